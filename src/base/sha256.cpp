#include "base/sha256.h"

#include <openssl/evp.h>

#include "base/error.h"

namespace fumon {

namespace {

void check(bool worked) {
    if (!worked) throw Error("OpenSSL's libcrypto cannot compute SHA-256; memory may be exhausted");
}

}  // namespace

void Sha256Stream::Free::operator()(evp_md_ctx_st* context) const {
    EVP_MD_CTX_free(context);
}

Sha256Stream::Sha256Stream() : context_(EVP_MD_CTX_new()) {
    check(context_ != nullptr);
    check(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1);
}

void Sha256Stream::add(const void* bytes, std::size_t count) {
    check(EVP_DigestUpdate(context_.get(), bytes, count) == 1);
}

Sha256 Sha256Stream::so_far() const {
    Sha256Stream copy;
    check(EVP_MD_CTX_copy_ex(copy.context_.get(), context_.get()) == 1);
    return copy.finish();
}

Sha256 Sha256Stream::finish() {
    Sha256 hash{};
    unsigned length = 0;
    check(EVP_DigestFinal_ex(context_.get(), hash.data(), &length) == 1);
    check(length == hash.size());
    return hash;
}

}  // namespace fumon
