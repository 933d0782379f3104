#include "core/io/obj_statements.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

namespace voxprite {
namespace {

// Faces of more are refused: cutting them into triangles takes time beyond measure.
constexpr std::size_t kMostCorners = 255;
// Far beyond what may be meant, and where sums of squares still are numbers.
constexpr double kMostNumber = 1e30;
constexpr std::string_view kBlanks = " \t";
// Between numbers; the last where a line goes on in the next.
constexpr std::string_view kSpace = " \t\r\n\\";

template <class Number>
bool isWhole(std::string_view word, Number& number) {
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    return error == std::errc{} && end == word.data() + word.size();
}

class StatementReader {
  public:
    explicit StatementReader(std::string_view text) : all_(text) {}

    Result<ObjStatements> run() {
        made_.text.reserve(all_.size() + 1);
        while (at_ < all_.size()) {
            const std::string_view line = nextLine();
            const std::string_view statement = withoutBlanks(line);
            const std::string_view name = statement.substr(0, statement.find_first_of(kSpace));
            const std::string_view rest = withoutBlanks(statement.substr(name.size()));
            if (name == "v" || name == "vt" || name == "f") {
                if (Status s = numbers(name, line); !s) return Failure(s.error());
            } else if (name == "mtllib") {
                made_.libraries.emplace_back(rest);
            } else if (name == "usemtl") {
                use(std::string(rest));
            }
        }
        if (Status s = check(vertices_); !s) return Failure(s.error());
        if (Status s = check(texturePoints_); !s) return Failure(s.error());
        return std::move(made_);
    }

  private:
    // Things that faces name by their numbers.
    struct Named {
        const char* what;
        std::int64_t count = 0;
        // The greatest that a face names, and where: later lines may have it.
        std::int64_t greatest = 0;
        std::string_view place{};
    };

    std::string_view nextLine() {
        const std::size_t from = at_;
        const std::size_t end = std::min(all_.find_first_of("\r\n", from), all_.size());
        const bool pair = end + 1 < all_.size() && all_[end] == '\r' && all_[end + 1] == '\n';
        at_ = end + (pair ? 2 : 1);
        return all_.substr(from, end - from);
    }

    template <class... Parts>
    [[nodiscard]] Status failAt(std::string_view word, const Parts&... parts) const {
        const auto offset = static_cast<std::size_t>(word.data() - all_.data());
        int line = 1;
        std::size_t start = 0;
        for (std::size_t k = 0; k < offset; ++k) {
            const bool pair = all_[k] == '\r' && all_[k + 1] == '\n';
            if (pair || (all_[k] != '\r' && all_[k] != '\n')) continue;
            ++line;
            start = k + 1;
        }
        std::string message;
        ((message += parts), ...);
        return failAtLine(line, static_cast<int>(offset - start) + 1, message);
    }

    // `line` is the first of the statement, which may go on.
    Status numbers(std::string_view name, std::string_view line) {
        std::string_view part = line.substr(0, line.find('#'));
        std::vector<std::string_view> words;
        while (true) {
            for (std::size_t k = part.find_first_not_of(kSpace); k < part.size();) {
                const std::size_t end = std::min(part.find_first_of(kSpace, k), part.size());
                words.push_back(part.substr(k, end - k));
                k = part.find_first_not_of(kSpace, end);
            }
            if (!withoutBlanks(part).ends_with('\\') || at_ >= all_.size()) break;
            const std::string_view next = nextLine();
            part = next.substr(0, next.find('#'));
        }
        const std::string_view statement = words.front();
        words.erase(words.begin());
        if (name == "f") return face(statement, words);
        const std::size_t least = name == "v" ? 3 : 1;
        if (words.size() < least) {
            return failAt(statement, "\"", name, "\" has ", std::to_string(words.size()),
                          " numbers; at least ", std::to_string(least), " are needed");
        }
        for (const std::string_view word : words) {
            double number = 0.0;
            if (!isWhole(word, number) || !(std::abs(number) <= kMostNumber)) {
                return failAt(word, "\"", word, "\" is not a number");
            }
        }
        ++(name == "v" ? vertices_ : texturePoints_).count;
        add(name, words);
        return {};
    }

    Status face(std::string_view statement, const std::vector<std::string_view>& words) {
        if (words.size() > kMostCorners) {
            return failAt(statement, "a face has ", std::to_string(words.size()),
                          " corners; at most ", std::to_string(kMostCorners), " are read");
        }
        std::vector<std::string> corners;
        for (const std::string_view word : words) {
            // Vertex, texture point and normal.
            const std::size_t slash = word.find('/');
            Result<std::string> corner = index(word.substr(0, slash), vertices_);
            if (!corner) return Failure(corner.error());
            if (slash != std::string_view::npos) {
                const std::string_view rest = word.substr(slash + 1);
                const std::string_view point = rest.substr(0, rest.find('/'));
                if (!point.empty()) {
                    const Result<std::string> second = index(point, texturePoints_);
                    if (!second) return Failure(second.error());
                    *corner += '/' + *second;
                }
            }
            corners.push_back(std::move(*corner));
        }
        add("f", corners);
        return {};
    }

    // Counted from 1; below 0 from the last one so far.
    Result<std::string> index(std::string_view word, Named& named) {
        int given = 0;
        if (!isWhole(word, given) || given == 0) {
            return Failure(failAt(word, "\"", word, "\" is no number of a ", named.what).error());
        }
        const std::int64_t number = given > 0 ? given : named.count + 1 + given;
        if (number < 1) {
            return Failure(failAt(word, "a face uses ", named.what, " ", std::to_string(given),
                                  "; before it are ", std::to_string(named.count))
                               .error());
        }
        if (number > named.greatest) {
            named.greatest = number;
            named.place = word;
        }
        return std::to_string(number);
    }

    [[nodiscard]] Status check(const Named& named) const {
        if (named.greatest <= named.count) return {};
        return failAt(named.place, "a face uses ", named.what, " ", std::to_string(named.greatest),
                      "; the file has ", std::to_string(named.count));
    }

    template <class Words>
    void add(std::string_view name, const Words& words) {
        made_.text += name;
        for (const auto& word : words) (made_.text += ' ') += word;
        made_.text += '\n';
    }

    void use(const std::string& material) {
        const auto [found, fresh] = materials_.try_emplace(material, made_.materials.size());
        if (fresh) made_.materials.push_back(material);
        made_.text += "usemtl " + std::to_string(found->second) + '\n';
    }

    std::string_view all_;
    std::size_t at_ = 0;
    ObjStatements made_;
    std::map<std::string, std::size_t> materials_;
    Named vertices_{.what = "vertex"};
    Named texturePoints_{.what = "texture point"};
};

}  // namespace

Result<ObjStatements> objStatements(ByteView file) {
    return StatementReader(textWithoutMark(file)).run();
}

std::string_view textWithoutMark(ByteView file) {
    std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    return text;
}

std::string_view withoutBlanks(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

}  // namespace voxprite
