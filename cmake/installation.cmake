# What an installation holds beside the program, and the CMake package that builds styles outside of the tree. The build
# folder has the same layout: share/hatchway there links to the sources, so that edits show at once.
#   component library: the engine; development: headers and package; runtime: everything else
include(CMakePackageConfigHelpers)

# hatchway_share(NAME FOLDER PATTERN...): FOLDER's files are found at share/hatchway/NAME.
function(hatchway_share name folder)
    file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/share/hatchway")
    file(CREATE_LINK "${CMAKE_SOURCE_DIR}/${folder}" "${CMAKE_BINARY_DIR}/share/hatchway/${name}" SYMBOLIC)
    foreach(pattern ${ARGN})
        list(APPEND patterns PATTERN "${pattern}")
    endforeach()
    install(DIRECTORY "${folder}/" DESTINATION ${CMAKE_INSTALL_DATADIR}/hatchway/${name} COMPONENT runtime OPTIONAL
            FILES_MATCHING ${patterns})
endfunction()

hatchway_share(shaders scenegraph/render/shaders "*.glsl" "*.vert" "*.frag")
hatchway_share(kit npr_plugins/kit "*.glsl" "*.frag")
hatchway_share(new_style editor_tools/new_style "*.in")
hatchway_share(levels content/levels "*.json" "*.lightmap")
hatchway_share(models content/models "*.glb")
hatchway_share(maps content/maps "*.json" "*.png")

set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/hatchway")
set(build_package_folder "${CMAKE_BINARY_DIR}/${package_folder}")
install(TARGETS hatchway EXPORT hatchway_targets
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT library)
install(EXPORT hatchway_targets NAMESPACE hatchway:: DESTINATION ${package_folder} COMPONENT development)
export(EXPORT hatchway_targets NAMESPACE hatchway:: FILE "${build_package_folder}/hatchway_targets.cmake")

foreach(header ${HATCHWAY_STYLE_HEADERS})
    get_filename_component(folder ${header} DIRECTORY)
    install(FILES scenegraph/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/hatchway/${folder}
            COMPONENT development)
endforeach()
install(FILES "${CMAKE_BINARY_DIR}/include/hatchway/header_hash.hpp" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/hatchway
        COMPONENT development)
install(DIRECTORY npr_plugins/kit/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/hatchway/kit COMPONENT development
        FILES_MATCHING PATTERN "*.hpp")

configure_package_config_file(cmake/hatchwayConfig.cmake.in "${build_package_folder}/hatchwayConfig.cmake"
                              INSTALL_DESTINATION ${package_folder} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${build_package_folder}/hatchwayConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
configure_file(cmake/add_npr_plugin.cmake "${build_package_folder}/add_npr_plugin.cmake" COPYONLY)
install(FILES "${build_package_folder}/hatchwayConfig.cmake" "${build_package_folder}/hatchwayConfigVersion.cmake"
        cmake/add_npr_plugin.cmake DESTINATION ${package_folder} COMPONENT development)
