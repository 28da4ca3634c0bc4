// SPDX-License-Identifier: BSD-3-Clause
// The precompiled header of the test programs is built with this file.
int main() { return 0; }
