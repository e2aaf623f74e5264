# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Gives Python's tests the user's locale, as Qt does for its hosts; Python imports it at start."""

import locale

locale.setlocale(locale.LC_ALL, "")
assert locale.localeconv()["decimal_point"] == ",", "the locale has no decimal comma"
