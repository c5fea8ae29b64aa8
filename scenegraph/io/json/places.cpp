#include "hatchway/io/json/places.hpp"

#include <nlohmann/json.hpp>
#include <string>

namespace hw {
namespace {

/// Steps through the tokens of a JSON text. The text is known to be right.
class JsonWalker {
 public:
    JsonWalker(std::string_view text, std::size_t place) : text_(text), place_(place) {}

    char peek()
    {
        skip_blank();
        return place_ < text_.size() ? text_[place_] : '\0';
    }
    void step() { ++place_; }

    JsonPlace value()
    {
        skip_blank();
        const std::size_t begin = place_;
        int depth = 0;
        do {
            const char c = peek();
            if (c == '"')
                skip_text();
            else if (c == '{' || c == '[')
                ++depth, step();
            else if (c == '}' || c == ']')
                --depth, step();
            else if (c == ',' || c == ':')
                step();
            else
                skip_word();
        } while (depth > 0 && place_ < text_.size());
        return {begin, place_};
    }

 private:
    void skip_blank()
    {
        while (place_ < text_.size()) {
            const std::string_view rest = text_.substr(place_);
            if (rest.starts_with("//"))
                place_ = std::min(text_.find('\n', place_), text_.size());
            else if (rest.starts_with("/*"))
                place_ = std::min(text_.find("*/", place_ + 2), text_.size() - 2) + 2;
            else if (std::string_view(" \t\r\n\xef\xbb\xbf").find(text_[place_]) != std::string_view::npos)
                ++place_;
            else
                return;
        }
    }
    void skip_text()
    {
        for (++place_; place_ < text_.size() && text_[place_] != '"'; ++place_)
            if (text_[place_] == '\\') ++place_;
        ++place_;
    }
    void skip_word() { place_ = std::min(text_.find_first_of(" \t\r\n,:{}[]\"/", place_ + 1), text_.size()); }

    std::string_view text_;
    std::size_t place_;
};

struct MemberPlace {
    std::string name;
    JsonPlace value;
};

/// Of the object that stands at or after `begin`.
std::vector<MemberPlace> members_of(std::string_view text, std::size_t begin)
{
    std::vector<MemberPlace> members;
    JsonWalker walker(text, begin);
    walker.peek();
    walker.step();
    while (walker.peek() == '"' || walker.peek() == ',') {
        if (walker.peek() == ',') {
            walker.step();
            continue;
        }
        const JsonPlace name = walker.value();
        walker.peek();
        walker.step();  // the colon
        members.push_back({nlohmann::json::parse(name.text(text)).get<std::string>(), walker.value()});
    }
    return members;
}

}  // namespace

JsonPlace root_place(std::string_view text)
{
    return JsonWalker(text, 0).value();
}

std::optional<JsonPlace> member_place(std::string_view text, std::string_view name)
{
    for (const MemberPlace& member : members_of(text, 0))
        if (member.name == name) return member.value;
    return {};
}

std::optional<JsonPlace> last_member_place(std::string_view text)
{
    const std::vector<MemberPlace> members = members_of(text, 0);
    if (members.empty()) return {};
    return members.back().value;
}

std::vector<std::string> member_names(std::string_view text, std::string_view name)
{
    std::vector<std::string> names;
    const std::optional<JsonPlace> object = member_place(text, name);
    if (!object || text[object->begin] != '{') return names;
    for (MemberPlace& member : members_of(text, object->begin)) names.push_back(std::move(member.name));
    return names;
}

std::vector<JsonPlace> element_places(std::string_view text, const JsonPlace& array)
{
    std::vector<JsonPlace> elements;
    JsonWalker walker(text, array.begin);
    walker.step();
    while (walker.peek() != ']' && walker.peek() != '\0') {
        if (walker.peek() == ',')
            walker.step();
        else
            elements.push_back(walker.value());
    }
    return elements;
}

}  // namespace hw
