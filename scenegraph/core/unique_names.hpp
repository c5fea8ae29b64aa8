#pragma once

#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace hw {

/// Gives each of many things a name of its own. As fast for things that all want the same name as for others.
class UniqueNames {
 public:
    explicit UniqueNames(const std::vector<std::string>& taken = {}) : taken_(taken.begin(), taken.end()) {}

    /// `wanted`, or the first of wanted_2, wanted_3 and on that is free; taken from now on.
    std::string take(const std::string& wanted);

 private:
    std::unordered_set<std::string> taken_;
    std::unordered_map<std::string, int> next_;  ///< Numbers of a name below it are taken.
};

}  // namespace hw
