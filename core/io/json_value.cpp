#include "core/io/json_value.h"

#include <charconv>
#include <cmath>

namespace voxprite {

void JsonValue::fail(const std::string& reason) const {
    throw JsonFieldError{place_.empty() ? reason : place_ + ": " + reason};
}

bool JsonValue::boolean() const {
    if (!json_->is_boolean()) fail("must be true or false");
    return json_->get<bool>();
}

int JsonValue::integer(int min, int max) const {
    const auto inRange = [&](auto value) {
        return std::cmp_greater_equal(value, min) && std::cmp_less_equal(value, max);
    };
    const bool fits = json_->is_number_unsigned()  ? inRange(json_->get<std::uint64_t>())
                      : json_->is_number_integer() ? inRange(json_->get<std::int64_t>())
                                                   : false;
    if (!fits) {
        fail("must be a whole number from " + std::to_string(min) + " to " + std::to_string(max));
    }
    return json_->get<int>();
}

std::uint64_t JsonValue::unsigned64() const {
    if (!json_->is_number_unsigned()) fail("must be a whole number, not negative");
    return json_->get<std::uint64_t>();
}

double JsonValue::number() const {
    if (!json_->is_number()) fail("must be a number");
    const auto value = json_->get<double>();
    if (!std::isfinite(value)) fail("must be a finite number");
    return value;
}

std::string JsonValue::text() const {
    if (!json_->is_string()) fail("must be a text");
    return bytesFromJsonText(json_->get_ref<const std::string&>());
}

glm::ivec3 JsonValue::integers3() const {
    const std::vector<JsonValue> values = list(3);
    return {values[0].integer(), values[1].integer(), values[2].integer()};
}

glm::dvec3 JsonValue::numbers3() const {
    const std::vector<JsonValue> values = list(3);
    return {values[0].number(), values[1].number(), values[2].number()};
}

Rgba8 JsonValue::colour() const {
    const std::optional<Rgba8> colour =
        json_->is_string() ? colourFromText(json_->get_ref<const std::string&>()) : std::nullopt;
    if (!colour) fail("must be a colour such as \"#20a0ff\" or \"#20a0ff80\"");
    return *colour;
}

std::vector<JsonValue> JsonValue::list() const {
    if (!json_->is_array()) fail("must be a list");
    std::vector<JsonValue> values;
    values.reserve(json_->size());
    for (const nlohmann::ordered_json& element : *json_) {
        values.emplace_back(element, place_ + "[" + std::to_string(values.size()) + "]");
    }
    return values;
}

std::vector<JsonValue> JsonValue::list(std::size_t exactCount) const {
    if (!json_->is_array() || json_->size() != exactCount) {
        fail("must be a list of " + std::to_string(exactCount));
    }
    return list();
}

std::vector<std::pair<std::string, JsonValue>> JsonValue::members() const {
    if (!json_->is_object()) fail("must be an object");
    std::vector<std::pair<std::string, JsonValue>> members;
    for (const auto& [key, value] : json_->items()) {
        members.emplace_back(bytesFromJsonText(key), JsonValue(value, place_ + "." + key));
    }
    return members;
}

JsonObject::JsonObject(const JsonValue& value) : value_(value) {
    if (!value.json_->is_object()) value.fail("must be an object");
}

std::optional<JsonValue> JsonObject::find(const char* key) {
    asked_.insert(key);
    const auto found = value_.json_->find(key);
    if (found == value_.json_->end()) return std::nullopt;
    return JsonValue(*found, value_.place_.empty() ? key : value_.place_ + "." + key);
}

JsonValue JsonObject::need(const char* key) {
    std::optional<JsonValue> value = find(key);
    if (!value) value_.fail(std::string("the field \"") + key + "\" is missing");
    return *value;
}

void JsonObject::refuseUnknown() const {
    for (const auto& [key, value] : value_.json_->items()) {
        if (!asked_.contains(key)) value_.fail("unknown field \"" + key + "\"");
    }
}

void JsonObject::read(const char* key, bool& value) {
    if (const auto field = find(key)) value = field->boolean();
}
void JsonObject::read(const char* key, int& value) {
    if (const auto field = find(key)) value = field->integer();
}
void JsonObject::read(const char* key, double& value) {
    if (const auto field = find(key)) value = field->number();
}
void JsonObject::read(const char* key, std::string& value) {
    if (const auto field = find(key)) value = field->text();
}
void JsonObject::read(const char* key, glm::dvec3& value) {
    if (const auto field = find(key)) value = field->numbers3();
}
void JsonObject::read(const char* key, Rgba8& value) {
    if (const auto field = find(key)) value = field->colour();
}

std::string colourText(Rgba8 colour) {
    constexpr const char* digits = "0123456789abcdef";
    std::string text = "#";
    for (int channel = 0; channel < (colour.w == 255 ? 3 : 4); ++channel) {
        text += digits[colour[channel] >> 4];
        text += digits[colour[channel] & 15];
    }
    return text;
}

std::optional<Rgba8> colourFromText(std::string_view text) {
    if ((text.size() != 7 && text.size() != 9) || text.front() != '#') return std::nullopt;
    Rgba8 colour(0, 0, 0, 255);
    for (std::size_t k = 1; k < text.size(); k += 2) {
        std::uint8_t value = 0;
        const char* const end = text.data() + k + 2;
        const auto parsed = std::from_chars(text.data() + k, end, value, 16);
        if (parsed.ec != std::errc{} || parsed.ptr != end) return std::nullopt;
        colour[static_cast<int>(k / 2)] = value;
    }
    return colour;
}

}  // namespace voxprite
