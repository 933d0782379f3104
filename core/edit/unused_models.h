// Models stay in a document when the last object that shows them goes, so that undo can bring it
// back. A file needs them no more.
#pragma once

#include "core/model/document.h"

namespace voxprite {

// How many models no object shows, hidden or not, in any frame.
[[nodiscard]] int unusedModels(const Document& document);
// Without them; those that stay keep their order.
[[nodiscard]] Document withoutUnusedModels(Document document);

}  // namespace voxprite
