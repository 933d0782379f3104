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

}  // namespace

Status chooseVariant(Palette& palette, const std::string& name) {
    const std::optional<std::size_t> variant = palette.variantNamed(name);
    if (!variant) {
        std::string known;
        for (const PaletteVariant& each : palette.variants) {
            known += (known.empty() ? "" : ", ") + each.name;
        }
        return fail("there is no palette variant \"" + name + "\"" +
                    (known.empty() ? "; the file has none" : " (there are: " + known + ")"));
    }
    palette = palette.withVariant(*variant);
    palette.variants.clear();
    return {};
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
              indexFrom, [&entity](int index) { entity = static_cast<std::size_t>(index); });
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
