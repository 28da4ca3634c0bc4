// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

struct evp_md_ctx_st;  // OpenSSL's digest context

namespace ridgeline::io {

/// SHA-256 of bytes that arrive in pieces, computed with OpenSSL.
class Sha256 {
 public:
  Sha256();
  void update(std::span<const std::byte> bytes);
  /// The digest of all bytes so far, 64 lower-case hexadecimal digits. The object must not be used
  /// afterwards.
  std::string hex_digest();

 private:
  struct Deleter {
    void operator()(evp_md_ctx_st* context) const;
  };
  std::unique_ptr<evp_md_ctx_st, Deleter> context_;
};

/// Digest of a file's content, 64 hexadecimal digits. Throws IoError if it cannot be read.
std::string sha256_of_file(const std::string& path);

}  // namespace ridgeline::io
