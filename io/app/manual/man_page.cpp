// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/manual/man_page.h"

#include <sstream>

namespace voussoir::io {
namespace {

/// Escapes text for groff: backslashes, hyphens, and control characters at the beginning of a line.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) out += "\\&";
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c;
    }
  }
  return out;
}

std::string bold(const std::string& text) { return "\\fB" + escaped(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + escaped(text) + "\\fR"; }

/// Word that stands for the value of an option: N in "-j N".
std::string value_word(const OptionRow& option) {
  if (option.value == "INT") return "N";
  if (option.value == "FLOAT") return "NUMBER";
  return option.value == "TEXT" ? "VALUE" : option.value;
}

std::string head(const std::string& title, const std::string& version) {
  return ".\\\" Made by `voussoir man` from its table of options; do not edit.\n.TH \"" + escaped(title) + "\" 1 \"\" \"voussoir " +
         escaped(version) + "\" \"Voussoir\"\n";
}

std::string synopsis_of(const std::string& command, const CommandRow& row) {
  std::string line = bold(command) + " [" + italic("options") + "]";
  for (const OptionRow& o : row.options) {
    if (!o.positional) continue;
    const std::string word = italic(o.names.front()) + (o.repeated ? "..." : "");
    line += o.required ? " " + word : " [" + word + "]";
  }
  return line + "\n";
}

std::string option_entry(const OptionRow& o) {
  std::string names;
  for (const std::string& name : o.names) names += (names.empty() ? "" : ", ") + (o.positional ? italic(name) : bold(name));
  if (!o.positional && !o.value.empty()) names += " " + italic(value_word(o));
  std::string text = ".TP\n" + names + "\n" + escaped(o.text) + "\n";
  std::string choices;
  for (const std::string& c : o.choices) choices += (choices.empty() ? "" : ", ") + c;
  if (!choices.empty()) text += ".br\nAllowed: " + escaped(choices) + ".\n";
  if (!o.range.empty()) text += ".br\nAllowed: " + escaped(o.range) + ".\n";
  return text;
}

std::string entries(const CommandRow& row, bool positional, const char* title) {
  std::string text;
  for (const OptionRow& o : row.options)
    if (o.positional == positional) text += option_entry(o);
  return text.empty() ? text : ".SH " + std::string(title) + "\n" + text;
}

/// "example: ..." and further lines at the end of the help, line by line.
std::string footer(const CommandRow& row) {
  if (row.footer.empty()) return "";
  std::string text = ".SH EXAMPLES\n.nf\n";
  std::istringstream lines(row.footer);
  for (std::string line; std::getline(lines, line);) {
    const std::string mark = "example: ";
    if (line.starts_with(mark)) line = line.substr(mark.size());
    text += escaped(line.substr(std::min(line.find_first_not_of(' '), line.size()))) + "\n";
  }
  return text + ".fi\n";
}

// As in io/README.md.
constexpr const char* kExitCodes = R"(.SH EXIT STATUS
.TP
0
done
.TP
1
numerical failure; of \fBcompare\fR and \fBrun \-\-verify\fR: not the same
.TP
2
usage or input
.TP
3
files; memory or a stack that cannot be had
.TP
4
this processor lacks instructions that the program was built for
.TP
130, 143
stopped by SIGINT or SIGTERM: \fBvoussoir resume\fR goes on
)";

constexpr const char* kSurroundings = R"(.SH ENVIRONMENT
.TP
.B OMP_NUM_THREADS
threads, where \fB\-\-threads\fR does not say
.TP
.B VOUSSOIR_CATALOGUE
a folder of further cases, known by the names of their files
.TP
.BR CHROMIUM ", " FFMPEG
the programs by these names, for stills and films
.SH FILES
.TP
.I /usr/share/doc/voussoir
the manual: cases and their keys, results, equations, the tutorial, ready cases to copy
.TP
.I /usr/share/voussoir/scripts
scripts in Python that draw figures, and studies of many runs
)";

std::string see_also(const OptionTable& table, const std::string& but) {
  std::string list;
  const auto add = [&](const std::string& page) {
    if (page != but) list += (list.empty() ? "" : ", ") + bold(page) + "(1)";
  };
  add("voussoir");
  for (const CommandRow& c : table.commands) add("voussoir-" + c.name);
  return ".SH SEE ALSO\n" + list + "\n";
}

ManPage program_page(const OptionTable& table, const std::string& version) {
  const CommandRow& p = table.program;
  const std::size_t colon = p.text.find(": ");  // "Voussoir: how masonry buildings ..."
  std::string text = head("VOUSSOIR", version) + ".SH NAME\nvoussoir \\- " +
                     escaped(colon == std::string::npos ? p.text : p.text.substr(colon + 2)) + "\n.SH SYNOPSIS\n" + bold("voussoir") + " " +
                     italic("COMMAND") + " [" + italic("options") + "]\n.SH COMMANDS\n";
  for (const CommandRow& c : table.commands) text += ".TP\n" + bold(c.name) + "\n" + escaped(c.text) + "\n";
  text += entries(p, false, "OPTIONS") + footer(p) + kExitCodes + kSurroundings + see_also(table, "voussoir");
  return {"voussoir.1", text};
}

ManPage command_page(const OptionTable& table, const CommandRow& c, const std::string& version) {
  const std::string name = "voussoir-" + c.name;
  std::string title = "VOUSSOIR-";
  for (const char letter : c.name) title += static_cast<char>(letter - 'a' + 'A');
  std::string text =
      head(title, version) + ".SH NAME\n" + name + " \\- " + escaped(c.text) + "\n.SH SYNOPSIS\n" + synopsis_of("voussoir " + c.name, c);
  text += entries(c, true, "ARGUMENTS") + entries(c, false, "OPTIONS") + footer(c) + kExitCodes + see_also(table, name);
  return {name + ".1", text};
}

}  // namespace

std::vector<ManPage> man_pages(const OptionTable& table, const std::string& version) {
  std::vector<ManPage> pages{program_page(table, version)};
  for (const CommandRow& c : table.commands) pages.push_back(command_page(table, c, version));
  return pages;
}

}  // namespace voussoir::io
