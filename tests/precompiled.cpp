// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Nothing of its own: what it is compiled with carries the headers that tests/CMakeLists.txt precompiles.
