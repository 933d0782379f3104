#include "app/cli/source.h"

#include "app/cli/arguments.h"
#include "core/io/profile_json.h"

namespace voxprite::cli {
namespace {

Document onlyModel(Document document, int model) {
    Document single = Document::withEmptyModel();
    single.models[0] = std::move(document.models[static_cast<std::size_t>(model)]);
    single.palette = std::move(document.palette);
    single.authored = document.authored;
    return single;
}

std::optional<std::size_t> entityFrom(std::string_view text) {
    const std::optional<int> index = indexFrom(text);
    if (!index || *index < 0) return std::nullopt;
    return static_cast<std::size_t>(*index);
}

}  // namespace

Result<std::size_t> variantNamed(const Palette& palette, const std::string& name) {
    if (const std::optional<std::size_t> variant = palette.variantNamed(name)) return *variant;
    std::string known;
    for (const PaletteVariant& each : palette.variants) {
        known += (known.empty() ? "" : ", ") + each.name;
    }
    return fail("there is no palette variant \"" + name + "\"" +
                (known.empty() ? "; the file has none" : " (there are: " + known + ")"));
}

Status chooseVariant(Palette& palette, const std::string& name) {
    const Result<std::size_t> variant = variantNamed(palette, name);
    if (!variant) return Failure(variant.error());
    palette = palette.withVariant(*variant);
    palette.variants.clear();
    return {};
}

Json warningsJson(const LoadedDocument& loaded) {
    Json warnings = Json::array();
    for (const std::string& warning : loaded.warnings) warnings.push_back(textJson(warning));
    return warnings;
}

std::vector<int> sourceModels(const Document& document) {
    std::vector<int> models;
    for (int k = 0; k < static_cast<int>(document.models.size()); ++k) {
        if (!document.models[static_cast<std::size_t>(k)].voxels.empty()) models.push_back(k);
    }
    return models;
}

Result<LoadedDocument> loadSource(const std::filesystem::path& path, std::optional<int> model,
                                  const std::optional<std::string>& variant,
                                  const ReadOptions& options) {
    Result<LoadedDocument> loaded = loadDocument(path, options);
    if (loaded && variant) {
        if (Status chosen = chooseVariant(loaded->document.palette, *variant); !chosen) {
            return Failure(inFile(std::move(chosen), path.string()).error());
        }
    }
    if (!loaded || !model) return loaded;
    const std::vector<int> models = sourceModels(loaded->document);
    if (*model < 0 || *model >= static_cast<int>(models.size())) {
        return failInFile(path.string(), "there is no model " + std::to_string(*model) +
                                             "; the file has " + std::to_string(models.size()) +
                                             " with voxels, counted from 0");
    }
    loaded->document =
        onlyModel(std::move(loaded->document), models[static_cast<std::size_t>(*model)]);
    return loaded;
}

void addEntityOption(CLI::App& app, std::optional<std::size_t>& entity) {
    addParsed(app, "--entity", "INDEX",
              "Of a .svo with several entities: this one, as `inspect` lists them (from 0)",
              entityFrom, [&entity](std::size_t index) { entity = index; });
}

Result<GameProfile> profileForSaving(const std::optional<std::string>& path,
                                     const Document& document) {
    if (path) return readProfileFile(*path);
    GameProfile profile;
    profile.voxelSizeMetres = document.authored.voxelSizeMetres;
    profile.sigma = document.authored.sigma;
    return profile;
}

}  // namespace voxprite::cli
