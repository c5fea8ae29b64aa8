# What the project's own plugins get beside a loadable library: a place in the static table, and installation.
include(add_npr_plugin)
set(HATCHWAY_IS_OWN_BUILD ON)

# hatchway_own_plugin(STYLE SOURCES...), called by add_npr_plugin().
function(hatchway_own_plugin style)
    add_library(static_plugin_${style} OBJECT ${ARGN})
    target_compile_definitions(static_plugin_${style} PRIVATE HW_PLUGIN_SYMBOL=hw_plugin_${style})
    target_link_libraries(static_plugin_${style} PRIVATE hatchway_flags)
    set_property(GLOBAL APPEND PROPERTY HATCHWAY_STYLES ${style})

    install(TARGETS plugin_${style} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/hatchway/plugins COMPONENT runtime)
    install(DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/" DESTINATION ${CMAKE_INSTALL_DATADIR}/hatchway/plugins/${style}
            COMPONENT runtime FILES_MATCHING PATTERN "*.frag" PATTERN "*.glsl")
endfunction()

# hatchway_static_plugin_table(): the library hatchway_static_plugins, all plugins so far and the table that names them.
function(hatchway_static_plugin_table)
    get_property(styles GLOBAL PROPERTY HATCHWAY_STYLES)
    set(declarations "")
    set(entries "")
    foreach(style ${styles})
        string(APPEND declarations "extern \"C\" const hw::PluginEntry* hw_plugin_${style}();\n")
        string(APPEND entries "        &hw_plugin_${style},\n")
        list(APPEND objects $<TARGET_OBJECTS:static_plugin_${style}>)
    endforeach()
    configure_file("${CMAKE_SOURCE_DIR}/cmake/static_plugins.cpp.in" "${CMAKE_BINARY_DIR}/static_plugins.cpp" @ONLY)
    add_library(hatchway_static_plugins STATIC EXCLUDE_FROM_ALL "${CMAKE_BINARY_DIR}/static_plugins.cpp" ${objects})
    target_link_libraries(hatchway_static_plugins PUBLIC hatchway PRIVATE hatchway_flags)
endfunction()
