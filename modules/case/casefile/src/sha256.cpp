#include "facenav/casefile/sha256.h"

#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <vector>

#include "facenav/core/error.h"

namespace facenav::casefile {
namespace {

class Sha256 {
 public:
  Sha256() : context_(EVP_MD_CTX_new(), &EVP_MD_CTX_free) {
    FACENAV_EXPECT(context_ && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1,
                   "SHA-256 is missing");
  }
  void add(const char* bytes, std::size_t count) {
    FACENAV_EXPECT(EVP_DigestUpdate(context_.get(), bytes, count) == 1, "SHA-256 failed");
  }
  std::string hex() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int size = 0;
    FACENAV_EXPECT(EVP_DigestFinal_ex(context_.get(), digest.data(), &size) == 1, "SHA-256 failed");
    std::string text;
    for (unsigned int i = 0; i < size; ++i) {
      text += "0123456789abcdef"[digest[i] >> 4];
      text += "0123456789abcdef"[digest[i] & 15];
    }
    return text;
  }

 private:
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

}  // namespace

std::string sha256OfFile(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream || std::filesystem::is_directory(path))
    throw Error("cannot be read", path.string(), "check the path");
  Sha256 hash;
  std::vector<char> block(1 << 16);
  while (stream.read(block.data(), std::streamsize(block.size())) || stream.gcount() > 0)
    hash.add(block.data(), std::size_t(stream.gcount()));
  if (stream.bad()) throw Error("cannot be read to its end", path.string());
  return hash.hex();
}

std::string sha256OfText(const std::string& text) {
  Sha256 hash;
  hash.add(text.data(), text.size());
  return hash.hex();
}

std::string sha256OfInput(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) return sha256OfFile(path);
  std::vector<std::string> hashes;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path))
    if (entry.is_regular_file()) hashes.push_back(sha256OfFile(entry.path()));
  std::sort(hashes.begin(), hashes.end());
  Sha256 hash;
  for (const std::string& text : hashes) hash.add(text.data(), text.size());
  return hash.hex();
}

}  // namespace facenav::casefile
