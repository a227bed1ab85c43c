# SPDX-License-Identifier: Apache-2.0
# For Doxygen: the comment that opens a header becomes that of its file, as it stands; lines keep their numbers.
NR == 1 { print "/** \\file"; opening = 1; held = "\\verbatim"; next }
opening && /^\/\// { if (NR > 2) print held; held = (NR == 2 ? "\\verbatim " : "") substr($0, 4); next }
opening { print held " \\endverbatim */"; opening = 0 }
{ print }
