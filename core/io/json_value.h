// Reading our own JSON field by field, with errors that name the field: "nodes[3].layer: ...".
// Private to core/io: a wrong field throws JsonFieldError, which the file's reader (readFields)
// turns into a Result.
#pragma once

#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/image.h"
#include "core/io/json_text.h"

namespace voxprite {

struct JsonFieldError {
    std::string message;
};

// A value and where it stands in its file. Does not own the JSON.
class JsonValue {
  public:
    JsonValue(const nlohmann::ordered_json& json, std::string place)
        : json_(&json), place_(std::move(place)) {}

    [[noreturn]] void fail(const std::string& reason) const;
    [[nodiscard]] const std::string& place() const { return place_; }

    [[nodiscard]] bool boolean() const;
    [[nodiscard]] int integer(int min = std::numeric_limits<int>::min(),
                              int max = std::numeric_limits<int>::max()) const;
    [[nodiscard]] std::uint64_t unsigned64() const;
    [[nodiscard]] double number() const;
    [[nodiscard]] std::string text() const;
    [[nodiscard]] glm::ivec3 integers3() const;
    [[nodiscard]] glm::dvec3 numbers3() const;
    // "#rrggbb" (alpha 255) or "#rrggbbaa".
    [[nodiscard]] Rgba8 colour() const;

    [[nodiscard]] std::vector<JsonValue> list() const;
    [[nodiscard]] std::vector<JsonValue> list(std::size_t exactCount) const;
    // Every member of an object, by key.
    [[nodiscard]] std::vector<std::pair<std::string, JsonValue>> members() const;

  private:
    friend class JsonObject;
    const nlohmann::ordered_json* json_;
    std::string place_;
};

// An object of known fields.
class JsonObject {
  public:
    explicit JsonObject(const JsonValue& value);
    [[nodiscard]] std::optional<JsonValue> find(const char* key);
    [[nodiscard]] JsonValue need(const char* key);
    // Fails on any field that was not asked for.
    void refuseUnknown() const;

    // The field's value, or the value as it was when there is no such field.
    void read(const char* key, bool& value);
    void read(const char* key, int& value);
    void read(const char* key, double& value);
    void read(const char* key, std::string& value);
    void read(const char* key, glm::dvec3& value);
    void read(const char* key, Rgba8& value);

  private:
    JsonValue value_;
    std::set<std::string> asked_;
};

[[nodiscard]] std::string colourText(Rgba8 colour);  // "#rrggbbaa", "#rrggbb" when alpha is 255
[[nodiscard]] std::optional<Rgba8> colourFromText(std::string_view text);

template <class Read>
[[nodiscard]] auto readFields(Read&& read) -> Result<decltype(read())> {
    try {
        return read();
    } catch (const JsonFieldError& error) {
        return fail(error.message);
    }
}

}  // namespace voxprite
