# Writes to OUT what Debian asks of a package beside the installed files: a manual page of the
# program and of each of its commands, of their help by help2man, the changelogs and the licence.
# cmake -D PROGRAM=... -D VERSION=... -D OUT=... -D SOURCE_DIR=... -P debian_files.cmake
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY OUTPUT_VARIABLE output)
  set(output "${output}" PARENT_SCOPE)
endfunction()

# Reproducible: no name, no time within.
function(compress file)
  run(gzip -9nf ${file})
endfunction()

# Of the program, or of one of its commands.
function(manual_page name command summary)
  run(help2man --no-info --section=1 --version-string=${VERSION} --name=${summary} --output=${OUT}/man1/${name}.1
      ${command})
  file(READ ${OUT}/man1/${name}.1 page)  # help2man knows no commands of a program
  string(REGEX REPLACE "(\n.SH NAME\n)[^\\]*" "\\1${name} " page "${page}")
  file(WRITE ${OUT}/man1/${name}.1 "${page}")
  compress(${OUT}/man1/${name}.1)
endfunction()

file(REMOVE_RECURSE ${OUT})
file(MAKE_DIRECTORY ${OUT}/man1 ${OUT}/doc)
manual_page(ridgeline ${PROGRAM} "3D line segments from aerial images, judged against LIDAR")
run(${PROGRAM} --help)
string(REGEX REPLACE ".*\nSubcommands:\n" "" commands "${output}")
string(REGEX MATCHALL "  [a-z]+ +[^\n]+" commands "${commands}")
foreach(line IN LISTS commands)
  string(REGEX MATCH "  ([a-z]+) +(.+)" matched "${line}")
  manual_page(ridgeline-${CMAKE_MATCH_1} "${PROGRAM} ${CMAKE_MATCH_1}" "${CMAKE_MATCH_2}")
endforeach()

file(READ ${SOURCE_DIR}/LICENSE licence)
string(REGEX REPLACE "^[^\n]*\n\n[^\n]*\n\n" "" licence "${licence}")  # its name and the holders stand above it
string(REGEX REPLACE "\n\n" "\n.\n" licence "${licence}")
string(REGEX REPLACE "\n" "\n " licence " ${licence}")
string(STRIP "${licence}" licence)
file(WRITE ${OUT}/doc/copyright "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/

Files: *
Copyright: 2026 the Ridgeline developers
License: BSD-3-Clause

Files: three.js (in the page of the report)
Copyright: 2010-2026 three.js authors
License: Expat

Files: uPlot (in the page of the report)
Copyright: 2022 Leon Sorokin
License: Expat

License: BSD-3-Clause
 ${licence}

License: Expat
 Permission is hereby granted, free of charge, to any person obtaining a copy
 of this software and associated documentation files (the \"Software\"), to deal
 in the Software without restriction, including without limitation the rights
 to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
 copies of the Software, and to permit persons to whom the Software is
 furnished to do so, subject to the following conditions:
 .
 The above copyright notice and this permission notice shall be included in
 all copies or substantial portions of the Software.
 .
 THE SOFTWARE IS PROVIDED \"AS IS\", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
 IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
 FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
 AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
 LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
 OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
 SOFTWARE.
")

file(COPY_FILE ${SOURCE_DIR}/CHANGELOG.md ${OUT}/doc/changelog)
compress(${OUT}/doc/changelog)
run(git -C ${SOURCE_DIR} log -1 --date=rfc2822 --format=%cd)
string(STRIP "${output}" date)
file(WRITE ${OUT}/doc/changelog.Debian "ridgeline (${VERSION}-1) unstable; urgency=medium

  * Release ${VERSION}: see changelog.gz.

 -- Ridgeline developers <developers@ridgeline.invalid>  ${date}
")
compress(${OUT}/doc/changelog.Debian)
