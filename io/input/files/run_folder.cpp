// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/input/files/run_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <new>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "io/input/files/descriptor.h"
#include "io/input/files/errors.h"
#include "io/input/files/output_path.h"
#include "io/input/files/sealed_pages.h"
#include "io/input/files/whole_file.h"

namespace voussoir::io {
namespace fs = std::filesystem;
namespace {

bool digits_only(const std::string& s) {
  return !s.empty() && std::ranges::all_of(s, [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// The final name of a temporary file NAME.tmp or NAME.PROCESS.tmp; other names unchanged.
std::string final_name(std::string name) {
  if (!name.ends_with(".tmp")) return name;
  name.resize(name.size() - 4);
  const std::size_t dot = name.rfind('.');
  if (dot != std::string::npos && digits_only(name.substr(dot + 1))) name.resize(dot);
  return name;
}

bool is_part(const std::string& found) {
  const std::string name = final_name(found), stem = name.substr(0, name.find('.'));
  return digits_only(stem) && name == stem + ".h5";
}

/// Whether the name is VIEW-TIMEs.png, as written by stills.cpp.
bool is_still(const std::string& found) {
  const std::string name = final_name(found);
  const std::size_t dash = name.find('-');
  if (dash == std::string::npos || !name.ends_with("s.png")) return false;
  const std::string time = name.substr(dash + 1, name.size() - dash - 6);
  return !time.empty() && time.find_first_not_of("0123456789.") == std::string::npos;
}

bool is_result(const std::string& found) {
  const std::string name = final_name(found);
  for (const char* own : {"run.h5", "case.toml", "report.html", "comparison.html", "run.xdmf", "paraview.h5", "limit.json"})
    if (name == own) return true;
  return name == "checkpoint-failed.h5" || checkpoint_number(name);
}

std::vector<std::string> names_in(const std::string& folder, bool (*chosen)(const std::string&)) {
  std::vector<std::string> names;
  if (!fs::is_directory(folder)) return names;
  for (const auto& entry : fs::directory_iterator(folder))
    if (chosen(entry.path().filename().string())) names.push_back(entry.path().filename().string());
  // In descending order: run.xdmf and run.h5 are removed first, since a partly removed run must not look like results.
  std::ranges::sort(names, std::greater<>());
  return names;
}

/// Files that no run wrote, judged by their names, except hidden files. Sorted, folders with a '/'.
std::vector<std::string> foreign_in(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with('.') || is_result(name)) continue;
    const bool own = name == "parts" ? !names_in(entry.path().string(), is_part).empty() || fs::is_empty(entry.path())
                                     : name == "stills" && !names_in(entry.path().string(), is_still).empty();
    if (!own) names.push_back(name + (entry.is_directory() ? "/" : ""));
  }
  std::ranges::sort(names);
  return names;
}

/// Whether the file is a case written by the user, not by a run.
bool is_own_case(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  return file && !(std::getline(file, line) && line.starts_with(kResolvedHead));
}

/// Refuses a folder with other contents than a run's. \throw FileError
void check_folder(const std::string& path, bool used, bool overwrite) {
  refuse_odd_file(path + "/case.toml");
  if (is_own_case(path + "/case.toml"))
    throw FileError(path + "/case.toml", "is no case that a run wrote, and would be replaced by one; give another folder");
  if (overwrite) return;
  if (used) throw FileError(path, "holds the results of another run; give another folder, or --overwrite to replace them");
  const std::vector<std::string> foreign = foreign_in(path);
  if (foreign.empty()) return;
  const std::string more = foreign.size() > 1 ? " and " + std::to_string(foreign.size() - 1) + " more" : "";
  throw FileError(path, "holds what is of no run (" + foreign.front() + more +
                            "); give a new or empty folder, or --overwrite to put the results beside it");
}

/// The kind of a result, by its name.
FileKind kind_of_result(const std::string& found) {
  const std::string name = final_name(found);
  if (name.ends_with(".html")) return FileKind::page;
  if (name.ends_with(".xdmf")) return FileKind::xdmf;
  if (name.ends_with(".png")) return FileKind::picture;
  return FileKind::hdf5;
}

/// Whether the file begins as a result of that kind: a checkpoint by its seal; with zeros if it was not written to its end.
bool begins_as(FileKind kind, const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(std::string_view(kSealedCheckpoint).size(), '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  return is_file_of_kind(kind, path) || (file.gcount() > 0 && head.front() == '\0') || head == kSealedCheckpoint;
}

/// Refuses a file that has the name of a result and other contents, since results would remove it. case.toml is told in check_folder.
/// \throw FileError
void refuse_other_kind(const std::string& path, const std::string& name) {
  if (const std::string wanted = final_name(name); wanted == "case.toml" || wanted == "limit.json") return;
  const FileKind kind = kind_of_result(name);
  if (begins_as(kind, path)) return;
  throw FileError(path, "is no " + name_of(kind) + ", so no run wrote it, but results would replace it; move it, or give another folder");
}

/// Refuses links in place of folders, in which a run writes and removes files. \throw FileError
void refuse_links(const std::string& folder) {
  for (const std::string& inner : {folder + "/parts", folder + "/stills"})
    if (fs::is_symlink(inner)) throw FileError(inner, "is a symbolic link, which results do not follow; give another folder");
}

/// Refuses a folder in which results would replace what is not a regular file of their kind, or an input of the command. \throw FileError
void check_files(const std::string& folder) {
  refuse_links(folder);
  const auto check = [](const std::string& in, bool (*chosen)(const std::string&)) {
    for (const std::string& name : names_in(in, chosen)) {
      const std::string path = in + "/" + name;
      refuse_odd_file(path);
      if (is_input(path)) throw FileError(path, "is an input of this command, which its results would replace; give another folder");
      refuse_other_kind(path, name);
    }
  };
  check(folder, is_result);
  check(folder + "/parts", is_part);
  check(folder + "/stills", is_still);
}

void remove_results(const std::string& folder) {
  for (const std::string& name : names_in(folder, is_result)) fs::remove(folder + "/" + name);
  const auto remove_in = [](const std::string& inner, bool (*chosen)(const std::string&)) {
    for (const std::string& name : names_in(inner, chosen)) fs::remove(inner + "/" + name);
    std::error_code not_empty;
    fs::remove(inner, not_empty);
  };
  remove_in(folder + "/parts", is_part);
  remove_in(folder + "/stills", is_still);
}

std::string holder(int lock) {
  std::string text(32, '\0');
  const ssize_t n = ::pread(lock, text.data(), text.size(), 0);
  text.resize(n > 0 ? static_cast<std::size_t>(n) : 0);
  text = text.substr(0, text.find('\n'));
  return digits_only(text) ? "process " + text : "another process";
}

/// Whether an open file is a lock of a run: a regular file, empty or with the number of a process.
bool is_lock(int file) {
  struct stat is {};
  std::string text(32, '\0');
  if (::fstat(file, &is) != 0 || !S_ISREG(is.st_mode)) return false;
  const ssize_t n = ::pread(file, text.data(), text.size(), 0);
  text.resize(n > 0 ? static_cast<std::size_t>(n) : 0);
  return is.st_size == 0 || (text.ends_with('\n') && digits_only(text.substr(0, text.size() - 1)));
}

/// Takes the lock. Tries for a moment, since a reader that looks at it holds it, too (holder_of).
bool locks(int file) {
  for (int attempt = 0;; ++attempt) {
    if (::flock(file, LOCK_EX | LOCK_NB) == 0) return true;
    if (errno != EWOULDBLOCK || attempt == 10) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

int take_lock(const std::string& folder) {
  refuse_odd_file(folder + "/.lock");
  Descriptor lock(folder + "/.lock", O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK);
  if (!is_lock(lock.id())) throw FileError(folder + "/.lock", "is no lock of a run, and would be overwritten by one; give another folder");
  if (!locks(lock.id())) {
    if (errno == EWOULDBLOCK) throw FileError(folder, "is in use by " + holder(lock.id()) + "; give another folder or wait for it to end");
    throw FileError(folder + "/.lock", "cannot lock: " + system_words(errno));
  }
  const std::string pid = std::to_string(::getpid()) + "\n";
  if (::ftruncate(lock.id(), 0) != 0) throw FileError(folder + "/.lock", "cannot write: " + system_words(errno));
  write_all(lock.id(), pid.data(), pid.size(), folder + "/.lock");
  return lock.release();
}

}  // namespace

std::optional<long> checkpoint_number(const std::string& name) {
  constexpr std::string_view kHead = "checkpoint-", kTail = ".h5";
  if (!name.starts_with(kHead) || !name.ends_with(kTail) || name.size() <= kHead.size() + kTail.size()) return std::nullopt;
  const std::string digits = name.substr(kHead.size(), name.size() - kHead.size() - kTail.size());
  if (digits.size() > 9 || digits.find_first_not_of("0123456789") != std::string::npos) return std::nullopt;
  return std::stol(digits);
}

std::optional<std::string> holder_of(const std::string& folder) {
  const int lock = ::open((folder + "/.lock").c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (lock < 0) return std::nullopt;
  std::optional<std::string> found;
  if (is_lock(lock)) found = ::flock(lock, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK ? holder(lock) : "";
  ::close(lock);
  return found;
}

RunFolder::RunFolder(std::string path) : path_(std::move(path)) {
  while (path_.size() > 1 && path_.ends_with('/')) path_.pop_back();
  lock_ = take_lock(path_);
}

RunFolder::RunFolder(RunFolder&& other) noexcept : path_(std::move(other.path_)), lock_(std::exchange(other.lock_, -1)) {}

RunFolder::~RunFolder() {
  // The lock file is kept: if it were removed, a third process could lock a new file while a second one waits for the old one.
  if (lock_ >= 0) ::close(lock_);
}

RunFolder RunFolder::create(const std::string& path, bool overwrite) {
  if (path.empty()) throw FileError("\"\"", "the folder for results has no name");
  std::error_code error;
  if (fs::exists(path, error) && !fs::is_directory(path, error)) throw FileError(path, "is a file; results need a folder");
  fs::create_directories(path, error);
  if (error) throw FileError(path, "cannot make the folder: " + error.message());
  const auto check = [&] {
    const bool used = !names_in(path, is_result).empty() || !names_in(path + "/parts", is_part).empty();
    check_folder(path, used, overwrite);
    check_files(path);
    return used;
  };
  try {
    if (!fs::exists(path + "/.lock", error)) check();  // before the folder is changed
    RunFolder folder(path);
    if (check()) remove_results(path);
    return folder;
  } catch (const fs::filesystem_error& e) {
    if (e.code() == std::errc::not_enough_memory) throw std::bad_alloc();
    throw FileError(path, "cannot remove old results: " + e.code().message());
  }
}

void RunFolder::write_case(const std::string& toml) const { write_text_file(file("case.toml"), toml); }

RunFolder RunFolder::open(const std::string& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) throw FileError(path, "is no folder of a run");
  check_files(path);
  return RunFolder(path);
}

}  // namespace voussoir::io
