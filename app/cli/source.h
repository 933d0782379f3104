// What commands read: a file's document, or one source model of it.
#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <optional>
#include <vector>

#include "app/cli/command.h"
#include "core/base/result.h"
#include "core/io/formats.h"

namespace voxprite::cli {

// The models that have voxels, in file order, as indices into Document::models. `inspect` lists
// them and --model N counts them, from 0.
[[nodiscard]] std::vector<int> sourceModels(const Document& document);

// The document of a file; with `model`, only that source model, without its placement; with
// `variant`, in the colours of that palette variant, which are then the palette's only ones.
[[nodiscard]] Result<LoadedDocument> loadSource(
    const std::filesystem::path& path, std::optional<int> model,
    const std::optional<std::string>& variant = std::nullopt, const ReadOptions& options = {});

// What the reader had to say, for a report.
[[nodiscard]] Json warningsJson(const LoadedDocument& loaded);

// --entity INDEX: of a .svo with several entities.
void addEntityOption(CLI::App& app, std::optional<std::size_t>& entity);
inline void addEntityOption(CLI::App& app, ReadOptions& options) {
    addEntityOption(app, options.entity);
}

// The variant of that name; the failure says which there are.
[[nodiscard]] Result<std::size_t> variantNamed(const Palette& palette, const std::string& name);
// The colours of a variant, by its name, in place of the palette's own; then there are no variants.
[[nodiscard]] Status chooseVariant(Palette& palette, const std::string& name);

// The profile of `path`; without one the built-in profile with the values that the document was
// authored with (what goes into files that record them).
[[nodiscard]] Result<GameProfile> profileForSaving(const std::optional<std::string>& path,
                                                   const Document& document);

}  // namespace voxprite::cli
