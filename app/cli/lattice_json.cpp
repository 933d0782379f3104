#include "app/cli/lattice_json.h"

#include "core/base/file.h"
#include "core/io/json_value.h"

namespace voxprite::cli {
namespace {

Json vectorJson(glm::ivec3 v) {
    return {v.x, v.y, v.z};
}
Json vectorJson(glm::ivec2 v) {
    return {v.x, v.y};
}

glm::ivec2 pairFrom(const JsonValue& value) {
    const std::vector<JsonValue> values = value.list(2);
    return {values[0].integer(), values[1].integer()};
}

LatticeView latticeFrom(const JsonValue& value) {
    JsonObject object(value);
    JsonObject bits(object.need("bits"));
    LatticeView lattice;
    lattice.positionBits = bits.need("position").integer(0, 30);
    lattice.directionBits = bits.need("direction").integer(0, 30);
    static_cast<void>(bits.need("step").integer(kStepShift, kStepShift));  // the only one there is
    lattice.C = object.need("C").integers3();
    lattice.D = object.need("D").integers3();
    lattice.U = object.need("U").integers3();
    lattice.V = object.need("V").integers3();
    lattice.first = pairFrom(object.need("first"));
    lattice.size = pairFrom(object.need("size"));
    return lattice;
}

LatticeFile latticeFileFrom(const Json& json) {
    const JsonValue root(json, "");
    JsonObject object(root);
    const std::optional<JsonValue> nested = object.find("lattice");
    if (!nested) return {latticeFrom(root), std::nullopt};
    LatticeFile file{latticeFrom(*nested), std::nullopt};
    if (const auto sigma = object.find("sigma_in_force")) file.sigmaInForce = sigma->number();
    return file;
}

Result<LatticeFile> readChecked(const std::string& path, glm::ivec3 modelSize) {
    const Result<std::string> text = readTextFile(path);
    if (!text) return Failure(text.error());
    const Result<Json> json = parseJson(*text);
    if (!json) return Failure(json.error());
    Result<LatticeFile> file = readFields([&] { return latticeFileFrom(*json); });
    if (!file) return file;
    if (Status valid = validateLattice(file->lattice, modelSize); !valid) {
        return Failure(valid.error());
    }
    return file;
}

}  // namespace

Json latticeJson(const LatticeView& lattice) {
    return {{"bits",
             {{"position", lattice.positionBits},
              {"direction", lattice.directionBits},
              {"step", kStepShift}}},
            {"C", vectorJson(lattice.C)},
            {"D", vectorJson(lattice.D)},
            {"U", vectorJson(lattice.U)},
            {"V", vectorJson(lattice.V)},
            {"first", vectorJson(lattice.first)},
            {"size", vectorJson(lattice.size)}};
}

Result<LatticeFile> readLatticeFile(const std::string& path, glm::ivec3 modelSize) {
    return inFile(readChecked(path, modelSize), path);
}

}  // namespace voxprite::cli
