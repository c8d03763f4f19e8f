# CPack runs this on the files of the package before it packs them (cmake/Package.cmake): a manual page and Debian's changelog are
# added, and times and rights are set.
set(ENV{LC_ALL} C.UTF-8)
set(root ${CPACK_TEMPORARY_DIRECTORY})

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# The manual page is what the program says of itself.
file(MAKE_DIRECTORY ${root}/usr/share/man/man1)
run(help2man --no-info --no-discard-stderr --name=${CPACK_PACKAGE_DESCRIPTION_SUMMARY}
    --output=${root}/usr/share/man/man1/shellmatch.1 ${root}/usr/bin/shellmatch)
run(gzip -9n ${root}/usr/share/man/man1/shellmatch.1)

execute_process(COMMAND date --utc --rfc-email --date=@$ENV{SOURCE_DATE_EPOCH} OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)
set(changelog ${root}/usr/share/doc/${CPACK_PACKAGE_NAME}/changelog)
file(WRITE ${changelog} "${CPACK_PACKAGE_NAME} (${CPACK_DEBIAN_PACKAGE_VERSION}) unstable; urgency=medium\n
  * Built from the sources of this version, whose CHANGELOG.md says what is new.\n
 -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
run(gzip -9n ${changelog})

# Neither the umask of who builds nor the time of the build is in the package.
run(chmod -R u=rwX,go=rX ${root})
run(find ${root} -exec touch --no-dereference --date=@$ENV{SOURCE_DATE_EPOCH} {} +)
