// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

/// Files that a command writes: one place decides what may be replaced.
///
/// A file is replaced only if it is a regular file of the same kind, not an input of the command, and not named by another option of it.
/// Anything else, as a pipe, a device, a symbolic link or a file of another kind, is refused by name, with --overwrite too. All that a
/// command reads by read_text_file, and all that note_input names, are its inputs, under any of their names (hard links).
namespace voussoir::io {

/// Kinds of files, told apart by their first bytes.
enum class FileKind { page, drawing, table, picture, film, shapes, record, xdmf, hdf5, manual };

/// "page (HTML)", for messages.
std::string name_of(FileKind kind);
/// Whether a file that begins with `head` (some kB, or all of it) is of that kind. An empty file is of any kind.
bool is_of_kind(FileKind kind, std::string_view head);

/// A file to be written, and the option that names it.
struct Output {
  std::string path;  // empty: none
  FileKind kind;
  std::string option;
  bool overwrite = false;
};

/// Forgets inputs and outputs of an earlier command of the process.
void start_command();
/// Notes a file, or a folder's files, as input of the command. What does not exist is ignored.
void note_input(const std::string& path);
/// Notes what is read of a run: its results with their parts, its case, and the limit analysis beside them.
void note_run(const std::string& folder);
/// Whether the file is an input of the command.
bool is_input(const std::string& path);

/// Checks before the work, if the folder may still have to be made. \throw FileError
void refuse_to_replace(const Output& output);
/// Checks before the work, the folder too. \throw FileError
void check_output(const Output& output);
/// Checks once more, and writes the file: complete, or not at all. \throw FileError
void write_output(const Output& output, std::string_view bytes);

/// Refuses what is not a regular file, links too; what does not exist is accepted. \throw FileError
void refuse_odd_file(const std::string& path);
/// Whether the file is of that kind by its first bytes. \throw FileError if it cannot be read
bool is_file_of_kind(FileKind kind, const std::string& path);
/// Makes way for a temporary file: removes a regular file of that name. \return `path` \throw FileError as refuse_odd_file
std::string cleared(const std::string& path);

}  // namespace voussoir::io
