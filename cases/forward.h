// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// For headers that name a case or its model without a look inside: a new key of the case does not compile their readers again.
namespace voussoir::cases {

struct Case;
struct WallSpans;
struct Model;
struct NamedLaw;
struct SupportHistory;

}  // namespace voussoir::cases
