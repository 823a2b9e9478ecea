// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

namespace voussoir::io {

/// A Chromium without a window, told what to do over a socket of its own in the DevTools protocol (https://chromedevtools.github.io): no
/// port is opened, and nothing is guessed about when a page is ready. It draws without a graphics card, so that pictures are the same
/// everywhere.
class Browser {
 public:
  /// Starts the program that the environment variable CHROMIUM names, else chromium, chromium-browser or google-chrome of the PATH.
  /// \param scratch  an empty folder for its profile and log, to be removed once the browser is gone \throw FileError if there is none
  explicit Browser(const std::string& scratch);
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;
  /// Ends it, by force if it does not end by itself.
  ~Browser();

  /// Opens a page of this machine and waits until it is loaded. \param file  absolute path \param fragment  what follows '#' \throw
  /// FileError
  void open(const std::string& file, const std::string& fragment);
  /// The text that an expression of JavaScript gives, or the promise that it gives. \throw FileError, also for what the page throws
  std::string evaluate(const std::string& expression);

 private:
  struct Process;
  std::unique_ptr<Process> process_;
};

}  // namespace voussoir::io
