#pragma once

#include <map>
#include <string>
#include <vector>

#include "hatchway/io/json/fwd.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// Reads what nodes of a glTF model say of style and certainty: extras.hatchway.style and .certainty, the same as one
/// custom property named "hatchway.style", else a plain property "certainty". Numbers may be texts, as people type them
/// into Blender's panel. What is not understood is left out and remembered; a certainty out of range is the nearest
/// that is in it, and remembered, too. Private to io.
class ExtrasReader {
 public:
    explicit ExtrasReader(std::string file) : file_(std::move(file)) {}

    /// `stated`: the node as the model has it, at `pointer`.
    void read(const nlohmann::json& stated, const std::string& pointer, Node& node);

    /// One message for each kind of what was not understood: the first place, and how many there are.
    std::vector<std::string> doubts() const;

 private:
    struct Place {
        std::string pointer;
        std::size_t count = 0;
    };
    void read_property(const nlohmann::json& value, const std::string& name, const std::string& pointer, Node& node);
    void doubt(const std::string& what, const std::string& pointer);

    std::string file_;
    std::map<std::string, Place> places_;  ///< By what is said of them.
    std::size_t untold_ = 0;               ///< Of kinds past those that are told.
};

}  // namespace hw
