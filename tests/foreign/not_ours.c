/* SPDX-License-Identifier: Apache-2.0 */
int nothing_of_ours(void) { return 0; }
