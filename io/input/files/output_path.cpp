// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/files/output_path.h"

#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "io/input/files/descriptor.h"
#include "io/input/files/errors.h"
#include "io/input/files/whole_file.h"

namespace voussoir::io {
namespace fs = std::filesystem;
namespace {

using Identity = std::pair<dev_t, ino_t>;

/// Inputs by what they are on disk, outputs by their paths.
struct CommandFiles {
  std::mutex lock;
  std::set<Identity> inputs;
  std::map<std::string, std::string> outputs;  // path, option
};

CommandFiles& files() {
  static CommandFiles all;
  return all;
}

std::optional<Identity> identity(const std::string& path) {
  struct stat is {};
  if (::stat(path.c_str(), &is) != 0 || !S_ISREG(is.st_mode)) return std::nullopt;
  return Identity{is.st_dev, is.st_ino};
}

constexpr std::size_t kMostNoted = 10000;  // files of a folder

void note_files_in(const std::string& folder) {
  std::error_code error;
  std::size_t count = 0;
  for (fs::directory_iterator it(folder, error), end; !error && it != end && count < kMostNoted; it.increment(error), ++count)
    if (const auto found = identity(it->path().string())) {
      const std::scoped_lock hold(files().lock);
      files().inputs.insert(*found);
    }
}

std::string odd_kind(mode_t mode) {
  if (S_ISLNK(mode)) return "a symbolic link; outputs neither follow nor replace links: name the file itself";
  if (S_ISDIR(mode)) return "a folder; a file is wanted";
  if (S_ISFIFO(mode)) return "a pipe; outputs replace regular files only";
  if (S_ISSOCK(mode)) return "a socket; outputs replace regular files only";
  return "a device; outputs replace regular files only";
}

/// The folder's real name and the file's.
std::string real_name(const std::string& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error), folder = fs::weakly_canonical(absolute.parent_path(), error);
  return (folder / absolute.filename()).string();
}

void refuse_second_name(const Output& o) {
  const std::scoped_lock hold(files().lock);
  const auto [known, first] = files().outputs.emplace(real_name(o.path), o.option);
  if (first || known->second == o.option) return;
  throw FileError(o.path, "is named twice: by " + known->second + " and by " + o.option + "; name two files");
}

std::string head_of(const std::string& path) {
  std::string head(4096, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  if (in.bad() || (head.empty() && !in.eof())) throw FileError(path, "cannot be read, so it is not replaced");
  return head;
}

}  // namespace

void start_command() {
  const std::scoped_lock hold(files().lock);
  files().inputs.clear();
  files().outputs.clear();
}

void note_input(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) return note_files_in(path);
  const auto found = identity(path);
  const std::scoped_lock hold(files().lock);
  if (found) files().inputs.insert(*found);
}

void note_run(const std::string& folder) {
  for (const char* name : {"/run.h5", "/parts", "/case.toml", "/limit.json"}) note_input(folder + name);
}

bool is_input(const std::string& path) {
  const auto found = identity(path);
  const std::scoped_lock hold(files().lock);
  return found && files().inputs.contains(*found);
}

void refuse_odd_file(const std::string& path) {
  struct stat is {};
  if (::lstat(path.c_str(), &is) == 0 && !S_ISREG(is.st_mode)) throw FileError(path, "is " + odd_kind(is.st_mode));
}

bool is_file_of_kind(FileKind kind, const std::string& path) { return is_of_kind(kind, head_of(path)); }

std::string cleared(const std::string& path) {
  refuse_odd_file(path);
  ::unlink(path.c_str());
  return path;
}

void refuse_to_replace(const Output& o) {
  if (o.path.empty()) return;
  refuse_odd_file(o.path);
  refuse_second_name(o);
  std::error_code none;
  if (!fs::exists(o.path, none)) return;
  if (is_input(o.path)) throw FileError(o.path, "is an input of this command, which no output replaces; name another file");
  if (!is_of_kind(o.kind, head_of(o.path)))
    throw FileError(o.path, "is no " + name_of(o.kind) + ", and is not replaced by one, with --overwrite neither; name another file");
  if (!o.overwrite) throw FileError(o.path, "exists; --overwrite replaces it");
}

void check_output(const Output& o) {
  if (o.path.empty()) return;
  refuse_to_replace(o);
  const fs::path folder = fs::path(o.path).parent_path();
  std::error_code none;
  if (!folder.empty() && !fs::is_directory(folder, none))
    throw FileError(o.path, "cannot be written: there is no folder " + folder.string());
}

void write_output(const Output& o, std::string_view bytes) {
  check_output(o);
  write_whole_file(o.path, std::as_bytes(std::span(bytes)));
}

}  // namespace voussoir::io
