// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "io/app/manual/completion.h"

#include <algorithm>

namespace voussoir::io {
namespace {

constexpr const char* kMade = "# Made by `voussoir completion` from its table of options; do not edit.\n";
/// Prints the names of the ready cases.
constexpr const char* kCases = R"("$program" cases 2>/dev/null | sed -nE 's/^([a-z0-9-]+) .*/\1/p')";

std::string joined(const std::vector<std::string>& words, const char* between = " ") {
  std::string text;
  for (const std::string& w : words) text += (text.empty() ? "" : between) + w;
  return text;
}

bool takes_case(const CommandRow& c) {
  return std::any_of(c.options.begin(), c.options.end(), [](const OptionRow& o) { return o.positional && o.names.front() == "CASE"; });
}

std::string command_names(const OptionTable& table) {
  std::vector<std::string> names;
  for (const CommandRow& c : table.commands) names.push_back(c.name);
  return joined(names);
}

/// `text` as one word in single quotes.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string(R"('\'')") : std::string(1, c);
  return out + "'";
}

/// `text` with a backslash before each character of `marks`.
std::string marked(const std::string& text, const std::string& marks) {
  std::string out;
  for (const char c : text) {
    if (marks.find(c) != std::string::npos) out += '\\';
    out += c;
  }
  return out;
}

/// A branch of bash's `case`: options of a command, and values of options with choices.
std::string bash_command(const CommandRow& c) {
  std::vector<std::string> options;
  std::string values;
  for (const OptionRow& o : c.options) {
    if (o.positional) continue;
    options.push_back(long_name(o));
    if (!o.choices.empty()) values += "        " + joined(o.names, "|") + ") values=\"" + joined(o.choices) + "\" ;;\n";
  }
  std::string text = "    " + c.name + ")\n      options=\"" + joined(options) + "\"\n";
  if (takes_case(c)) text += "      [ \"$COMP_CWORD\" -ne 2 ] || words=$(" + std::string(kCases) + ")\n";
  if (!values.empty()) text += "      case $before in\n" + values + "      esac\n";
  return text + "      ;;\n";
}

/// An argument of zsh's _arguments.
std::string zsh_argument(const OptionRow& o) {
  const std::string text = "[" + marked(o.text, "[]") + "]";
  std::string behind;
  if (!o.choices.empty()) {
    behind = ":" + marked(o.value, ":") + ":(" + joined(o.choices) + ")";
  } else if (!o.value.empty()) {
    behind = ":" + marked(o.value, ":") + ":" + (o.value == "TEXT" ? "_files" : " ");  // numbers have no completion
  }
  if (o.positional) {
    const std::string what = o.names.front() == "CASE" ? "_voussoir_cases" : "_files";
    return quoted((o.repeated ? "*:" : ":") + o.names.front() + ":" + what);
  }
  if (o.repeated) return quoted("*" + long_name(o) + text + behind);
  if (o.names.size() == 1) return quoted(long_name(o) + text + behind);
  return quoted("(" + joined(o.names) + ")") + "{" + joined(o.names, ",") + "}" + quoted(text + behind);
}

/// A line of a fish script.
std::string fish_option(const CommandRow& c, const OptionRow& o) {
  std::string line = "complete -c voussoir -n " + quoted("__fish_seen_subcommand_from " + c.name);
  for (const std::string& name : o.names) line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!o.choices.empty()) {
    line += " -x -a " + quoted(joined(o.choices));
  } else if (!o.value.empty()) {
    line += " -r";
  }
  return line + " -d '" + marked(o.text, "\\'") + "'\n";
}

}  // namespace

std::string bash_completion(const OptionTable& table) {
  std::string text = kMade;
  text += R"(_voussoir() {
  local program=${COMP_WORDS[0]} command=${COMP_WORDS[1]} word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}
  local words="" options="" values=""
  case $command in
)";
  for (const CommandRow& c : table.commands) text += bash_command(c);
  return text + R"(  esac
  if [ "$COMP_CWORD" -eq 1 ]; then
    words=")" +
         command_names(table) + R"("
  elif [ -n "$values" ]; then
    words=$values
  elif [[ $word == -* ]]; then
    words=$options
  fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}
complete -o default -F _voussoir voussoir  # -o default: where nothing fits, names of files
)";
}

std::string zsh_completion(const OptionTable& table) {
  std::string text = "#compdef voussoir\n" + std::string(kMade) + "_voussoir_cases() {\n  local program=voussoir\n";
  text += "  local -a ready=(${(f)\"$(" + std::string(kCases) + ")\"})\n";
  text += R"ZSH(  _alternative "cases:ready case:($ready)" 'files:case file:_files -g "*.toml"'
}
_voussoir() {
  local curcontext=$curcontext state line
  typeset -A opt_args
  _arguments -C '1:command:->command' '*::argument:->argument'
  case $state in
    command)
      local -a known=(
)ZSH";
  for (const CommandRow& c : table.commands) text += "        " + quoted(c.name + ":" + marked(c.text, ":\\")) + "\n";
  text += "      )\n      _describe command known ;;\n    argument)\n      case ${line[1]} in\n";
  for (const CommandRow& c : table.commands) {
    text += "        " + c.name + ")\n          _arguments -s";
    for (const OptionRow& o : c.options) text += " \\\n            " + zsh_argument(o);
    text += " ;;\n";
  }
  return text +
         "      esac ;;\n  esac\n}\nif [ \"$funcstack[1]\" = _voussoir ]; then _voussoir \"$@\"; else compdef _voussoir voussoir; fi\n";
}

std::string fish_completion(const OptionTable& table) {
  std::string text = kMade;
  text += "function __voussoir_cases\n  set -l program (commandline -opc)[1]\n  " + std::string(kCases) + "\nend\n";
  const std::string none = quoted("not __fish_seen_subcommand_from " + command_names(table));
  for (const CommandRow& c : table.commands)
    text += "complete -c voussoir -f -n " + none + " -a " + c.name + " -d '" + marked(c.text, "\\'") + "'\n";
  for (const CommandRow& c : table.commands) {
    for (const OptionRow& o : c.options)
      if (!o.positional) text += fish_option(c, o);
    if (takes_case(c)) text += "complete -c voussoir -n " + quoted("__fish_seen_subcommand_from " + c.name) + " -a '(__voussoir_cases)'\n";
  }
  return text;
}

}  // namespace voussoir::io
