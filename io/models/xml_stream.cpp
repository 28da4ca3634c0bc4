// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/xml_stream.h"

#include "io/error.h"
#include "io/files/input_file.h"

#include <expat.h>
#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <memory>
#include <new>
#include <utility>

namespace ridgeline::io {
namespace {

constexpr char kSpaceEnd =
    '\n';  // between the namespace and the local name; neither can contain a line end

XmlName split_name(std::string_view name) {
  const std::size_t end = name.rfind(kSpaceEnd);
  if (end == std::string_view::npos) return {{}, name};
  return {name.substr(0, end), name.substr(end + 1)};
}

struct GzipDeleter {
  void operator()(gzFile file) const { gzclose(file); }
};
using GzipFile = std::unique_ptr<gzFile_s, GzipDeleter>;

/// The bytes of a file, unpacked if it is compressed with gzip.
class Unpacked {
 public:
  explicit Unpacked(const std::string& path) : path_(path) {
    require_regular_file(path);
    file_.reset(gzopen(path.c_str(), "rb"));
    if (!file_) throw IoError(path, "cannot be read");
    constexpr std::uintmax_t kMaxGrowth = 100;  // indented XML shrinks to a thirtieth
    constexpr std::uintmax_t kAlwaysRead_bytes = 64U << 20U;
    most_bytes_ = std::max(kAlwaysRead_bytes, kMaxGrowth * std::filesystem::file_size(path));
  }

  /// The next bytes; empty at the end.
  std::string_view next() {
    const int n_read = gzread(file_.get(), block_.data(), static_cast<unsigned>(block_.size()));
    int error = Z_OK;
    const char* const message = gzerror(file_.get(), &error);
    // gzread does not report a file that ends too early as an error
    if (n_read < 0 || error != Z_OK) {
      throw IoError(path_, fmt::format("cannot be unpacked: {}", message));
    }
    n_bytes_ += static_cast<std::uintmax_t>(n_read);
    if (n_bytes_ > most_bytes_) {
      throw IoError(path_, "unpacks to more than 100 times its size, more than any model");
    }
    return {block_.data(), static_cast<std::size_t>(n_read)};
  }

 private:
  std::string path_;
  GzipFile file_;
  std::uintmax_t n_bytes_ = 0;
  std::uintmax_t most_bytes_ = 0;
  std::array<char, 65536> block_{};
};

}  // namespace

std::string_view XmlAttributes::value(std::string_view local, std::string_view space) const {
  for (const char* const* pair = pairs_; *pair != nullptr; pair += 2) {
    const XmlName name = split_name(pair[0]);
    if (name.local != local || name.space.empty() != space.empty()) continue;
    if (name.space.starts_with(space)) return pair[1];
  }
  return {};
}

/// Expat's parser. Its callbacks must not throw, because expat is C: exceptions are kept until the
/// parser has returned.
struct XmlStream::Parser {
  Parser(const std::string& file, XmlEvents handlers)
      : path(file), events(std::move(handlers)), expat(XML_ParserCreateNS(nullptr, kSpaceEnd)) {
    if (expat == nullptr) throw std::bad_alloc();
    XML_SetUserData(expat, this);
    XML_SetElementHandler(expat, on_start, on_end);
    XML_SetCharacterDataHandler(expat, on_text);
    XML_SetCommentHandler(expat, [](void* user, const char*) { of(user).made_progress = true; });
    XML_SetStartDoctypeDeclHandler(expat, on_doctype);
  }
  ~Parser() { XML_ParserFree(expat); }
  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;

  static Parser& of(void* user) { return *static_cast<Parser*>(user); }

  [[nodiscard]] std::string place() const {
    return fmt::format("{}:{}", path, XML_GetCurrentLineNumber(expat));
  }

  template <typename Call>
  void guarded(const Call& call) {
    made_progress = true;
    if (thrown) return;
    try {
      call();
    } catch (...) {
      thrown = std::current_exception();
      XML_StopParser(expat, XML_FALSE);
    }
  }

  static void on_start(void* user, const char* name, const char** attributes) {
    Parser& parser = of(user);
    parser.guarded([&] {
      constexpr int kMaxDepth = 200;  // CityGML needs about 30
      if (++parser.depth > kMaxDepth) {
        throw IoError(parser.place(), fmt::format("more than {} elements are nested", kMaxDepth));
      }
      parser.events.start(split_name(name), XmlAttributes(attributes));
    });
  }

  static void on_end(void* user, const char* /*name*/) {
    Parser& parser = of(user);
    --parser.depth;
    parser.guarded([&] { parser.events.end(); });
  }

  static void on_text(void* user, const char* text, int length) {
    Parser& parser = of(user);
    parser.guarded([&] { parser.events.text({text, static_cast<std::size_t>(length)}); });
  }

  static void on_doctype(void* user, const char*, const char*, const char*, int) {
    Parser& parser = of(user);
    parser.guarded([&] {
      throw IoError(parser.place(),
                    "has a DOCTYPE; entities are not expanded and CityGML needs none; remove it");
    });
  }

  void parse(std::string_view bytes) {
    made_progress = false;
    const XML_Status status =
        XML_Parse(expat, bytes.data(), static_cast<int>(bytes.size()), bytes.empty() ? 1 : 0);
    if (thrown) std::rethrow_exception(thrown);
    if (status == XML_STATUS_ERROR) {
      throw IoError(place(), fmt::format("is not a complete XML document: {}",
                                         XML_ErrorString(XML_GetErrorCode(expat))));
    }
    require_end_of_token(bytes.size());
  }

  /// Expat keeps a tag until it is complete and reads it again from its start with each piece.
  void require_end_of_token(std::size_t n_bytes) {
    constexpr std::size_t kMaxToken_bytes = 4U << 20U;
    n_bytes_of_token = made_progress ? 0 : n_bytes_of_token + n_bytes;
    if (n_bytes_of_token > kMaxToken_bytes) throw IoError(place(), "a tag has more than 4 MiB");
  }

  std::string path;
  XmlEvents events;
  XML_Parser expat;
  int depth = 0;
  bool made_progress = false;
  std::size_t n_bytes_of_token = 0;
  std::exception_ptr thrown;
};

XmlStream::XmlStream(const std::string& path, XmlEvents events)
    : path_(path), parser_(std::make_unique<Parser>(path, std::move(events))) {}

XmlStream::~XmlStream() = default;

void XmlStream::read() {
  Unpacked file(path_);
  std::string_view bytes;
  do {
    bytes = file.next();
    parser_->parse(bytes);
  } while (!bytes.empty());
}

std::string XmlStream::place() const { return parser_->place(); }

}  // namespace ridgeline::io
