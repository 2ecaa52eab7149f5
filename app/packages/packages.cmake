# CPack packages of the installed files: scb, libscb1, libscb-dev and python3-scb for Debian, and an archive for other systems.
# app/packages/run builds them.
set(CPACK_PACKAGE_VENDOR "The scb authors")
set(CPACK_PACKAGE_CONTACT "The scb authors <scb@example.invalid>")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGE_FILE_NAME scb-${PROJECT_VERSION}-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB TZST)
set(CPACK_COMPONENTS_ALL program library development)
if(SCB_BUILD_PYTHON)
    list(APPEND CPACK_COMPONENTS_ALL python)
endif()
# One archive, but a Debian package per component.
set(CPACK_ARCHIVE_COMPONENT_INSTALL OFF)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/core)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(soname ${PROJECT_VERSION_MAJOR})
set(same_version "(= ${PROJECT_VERSION}-1)")
# scb_package(COMPONENT NAME SECTION DEPENDS SUMMARY TEXT)
macro(scb_package component name section depends summary text)
    string(TOUPPER ${component} upper)
    set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
    set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
    set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${depends}")
    set(CPACK_COMPONENT_${upper}_DESCRIPTION "${summary}\n${text}")
    # Debian requires a license and a changelog in every package.
    install(FILES app/packages/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${component})
    install(FILES app/packages/overrides/${component} DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides RENAME ${name} COMPONENT ${component})
    install(FILES ${PROJECT_BINARY_DIR}/packages/changelog.Debian.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${component})
endmacro()
scb_package(program scb science "" "headless visual debugger for bounding volume hierarchies"
    "Draws levels of hierarchies of slab cut balls, boxes and other volumes, the\npairs that collide and how overlap tests rejected the others; judges queries\nof any engine; and holds pictures and counts against baselines. It needs no\ndisplay.")
scb_package(library libscb${soname} libs "" "slab cut balls: hierarchies and collision queries"
    "Fits slab cut balls and other bounding volumes to triangle meshes, builds\nhierarchies of them, and finds the triangles of two bodies that intersect.\nThis package has the shared library.")
scb_package(development libscb-dev libdevel "libscb${soname} ${same_version}, libeigen3-dev, libtbb-dev, libhwy-dev" "slab cut balls: headers and libraries"
    "Fits slab cut balls and other bounding volumes to triangle meshes, builds\nhierarchies of them, and finds the triangles of two bodies that intersect.\nThis package has the headers, the static library, and files for CMake and\npkg-config.")
# An extension works with one minor version of Python only.
find_package(Python3 3.9 QUIET COMPONENTS Interpreter)
math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
set(of_python "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next_minor})")
scb_package(python python3-scb python "${of_python}, python3-numpy" "slab cut balls in Python"
    "Builds hierarchies, asks for collisions at thousands of poses at a time,\ndraws pictures of them, and reads traces and recordings, with arrays of\nnumpy.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/app/packages/python/postinst ${PROJECT_SOURCE_DIR}/app/packages/python/prerm)
# CPack strips the debug information, which app/packages/abi reads, from shared objects and programs, but not from archives.
install(CODE "execute_process(COMMAND ${CMAKE_OBJCOPY} --strip-debug
    \$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/libscb.a COMMAND_ERROR_IS_FATAL ANY)" COMPONENT development)
# For packages of programs that use the library.
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/app/packages/triggers)

file(READ app/packages/changelog changelog)
string(REPLACE "@VERSION@" ${PROJECT_VERSION} changelog "${changelog}")
file(WRITE ${PROJECT_BINARY_DIR}/packages/changelog.Debian "${changelog}")
execute_process(COMMAND gzip -9nc ${PROJECT_BINARY_DIR}/packages/changelog.Debian OUTPUT_FILE ${PROJECT_BINARY_DIR}/packages/changelog.Debian.gz
    COMMAND_ERROR_IS_FATAL ANY)
include(CPack)
