# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause

# The interface in C, as pages and, one for each function, as manual pages.
@INCLUDE               = docs/Doxyfile
PROJECT_NAME           = "libwinding"
PROJECT_BRIEF          = "Winding numbers of surfaces and point clouds, for C"
INPUT                  = filters/c/winding.h
STRIP_FROM_INC_PATH    = filters/c
HTML_OUTPUT            = library
USE_MDFILE_AS_MAINPAGE =
OPTIMIZE_OUTPUT_FOR_C  = YES
FILTER_PATTERNS        =
PREDEFINED             = WINDING_API=
GENERATE_MAN           = YES
MAN_EXTENSION          = .3
MAN_LINKS              = YES
