// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "io/input/files/errors.h"

namespace voussoir::io {

/// There is no Chromium.
class NoBrowser : public FileError {
 public:
  using FileError::FileError;
};

/// A Chromium without a window, controlled over a private socket by the DevTools protocol (https://chromedevtools.github.io): no port is
/// opened, and page events tell when a page is ready. Rendering is in software, so that pictures are the same on every machine.
class Browser {
 public:
  /// Starts the program named by the environment variable CHROMIUM, else chromium, chromium-browser or google-chrome of the PATH.
  /// \param scratch  an empty folder for its profile and log, to be removed after the browser has ended \throw NoBrowser
  explicit Browser(const std::string& scratch);
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;
  /// Ends the browser, by force if necessary.
  ~Browser();

  /// Opens a page of this machine and waits until it is loaded. \param file  absolute path \param fragment  text after '#' \throw FileError
  void open(const std::string& file, const std::string& fragment);
  /// The value of a JavaScript expression, or of the promise that it gives, as text. \throw FileError, also for exceptions of the page
  std::string evaluate(const std::string& expression);

 private:
  struct Process;
  std::unique_ptr<Process> process_;
};

}  // namespace voussoir::io
