#include "core/base/result.h"

namespace voxprite {

std::string onOneLine(std::string text) {
    for (char& c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7F) c = ' ';
    }
    return text;
}

std::string Error::describe() const {
    std::string text;
    if (!file.empty()) text += onOneLine(file) + ": ";
    if (offset) text += "byte " + std::to_string(*offset) + ": ";
    if (line) {
        text += "line " + std::to_string(*line);
        if (column) text += ", column " + std::to_string(*column);
        text += ": ";
    }
    return text + onOneLine(message);
}

Failure fail(std::string message) {
    Error error;
    error.message = std::move(message);
    return Failure(std::move(error));
}

Failure failAtByte(std::uint64_t offset, std::string message) {
    Error error;
    error.offset = offset;
    error.message = std::move(message);
    return Failure(std::move(error));
}

Failure failAtLine(int line, int column, std::string message) {
    Error error;
    error.line = line;
    error.column = column;
    error.message = std::move(message);
    return Failure(std::move(error));
}

Failure failInFile(std::string file, std::string message) {
    Error error;
    error.file = std::move(file);
    error.message = std::move(message);
    return Failure(std::move(error));
}

}  // namespace voxprite
