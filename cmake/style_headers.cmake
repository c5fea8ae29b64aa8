# The headers that a style sees: what crosses the boundary between the host and its plugins.

# hatchway_style_headers(RESULT HEADER...): the HEADERs, relative to scenegraph/, and every engine header that they
# include. Read again when one of them changes.
function(hatchway_style_headers result)
    set(open ${ARGN})
    set(seen "")
    while(open)
        list(POP_FRONT open header)
        if(header IN_LIST seen OR NOT EXISTS "${CMAKE_SOURCE_DIR}/scenegraph/${header}")
            continue()
        endif()
        list(APPEND seen ${header})
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/scenegraph/${header}")
        file(STRINGS "${CMAKE_SOURCE_DIR}/scenegraph/${header}" lines REGEX "^#include \"hatchway/")
        foreach(line ${lines})
            string(REGEX REPLACE "^#include \"hatchway/([^\"]+)\".*" "\\1" included "${line}")
            list(APPEND open ${included})
        endforeach()
    endwhile()
    list(SORT seen)
    set(${result} ${seen} PARENT_SCOPE)
endfunction()

# hatchway_write_header_hash(FILE): a header with a hash over all of them, which goes into HW_PLUGIN_BUILD. The list
# stays in HATCHWAY_STYLE_HEADERS.
function(hatchway_write_header_hash file)
    hatchway_style_headers(headers style/style.hpp core/error.hpp)
    set(text "")
    foreach(header ${headers})
        file(SHA256 "${CMAKE_SOURCE_DIR}/scenegraph/${header}" hash)
        string(APPEND text "${header} ${hash}\n")
    endforeach()
    string(SHA256 hash "${text}")
    string(SUBSTRING ${hash} 0 16 hash)
    file(CONFIGURE OUTPUT "${file}" CONTENT [[
#pragma once

/// Over all headers that a style sees; made by CMake.
#define HW_HEADER_HASH "@hash@"
]] @ONLY)
    set(HATCHWAY_STYLE_HEADERS ${headers} PARENT_SCOPE)
endfunction()
