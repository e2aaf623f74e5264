// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

/**
 * @file
 * SIGINT, SIGTERM and SIGHUP end the program; a SIGHUP that the caller ignores, as nohup does,
 * stays ignored. The first signal asks: running filters are aborted (Progress.h), and the
 * program leaves where it next looks. If that takes more than a second, or at a second signal, the
 * program leaves from the signal handler. Either way no half-written file stays.
 */
namespace interrupt
{

/// Handles signals in this way from now on.
void install();

/// The program is one of several ranks from now on. The launcher sends them a signal and kills them
/// a second later, so the signal handler waits for half a second only; and it leaves without a line
/// unless the rank is the first.
void joinRanks(bool isFirst);

/// The program has said how it ends, and ends: signals do nothing from now on. mpirun sends them to
/// all ranks as soon as one has ended with a status other than 0.
void ignore();

/// Whether a signal has come.
bool requested();

/// Throws Failure if a signal has come.
void check();

/// Keeps a name until the program ends, for addTemporaryFile(). That one asks for no memory, so
/// that nothing can come between a file and its removal.
const char* keepName(const std::string& path);

///@{
/// removeTemporaryFiles() removes the files that are added and not dropped again. Of more than
/// eight at a time, the ones that come late are not taken.
void addTemporaryFile(const char* keptName);
void dropTemporaryFile(const char* keptName);
///@}

/// Leaves these files to another process: this one, a child, is not to remove them.
void forgetTemporaryFiles();

/// Removes these files, for whoever leaves without unwinding. Signal handlers may call it.
void removeTemporaryFiles();

} // namespace interrupt
