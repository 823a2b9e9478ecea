/* SPDX-FileCopyrightText: 2026 The Voussoir authors
 * SPDX-License-Identifier: Apache-2.0
 *
 * What HDF5's driver for files in the network (ROS3) calls of libcurl and OpenSSL, for a program that has neither: there is no network. The
 * driver is never asked for; these are here so that it can be linked. */
#include <stddef.h>

enum { FAILED = 2 }; /* CURLE_FAILED_INIT */

int curl_global_init(long flags);
void curl_global_cleanup(void);
void* curl_easy_init(void);
int curl_easy_setopt(void* handle, int option, ...);
int curl_easy_perform(void* handle);
void curl_easy_cleanup(void* handle);
void* curl_slist_append(void* list, const char* text);
void curl_slist_free_all(void* list);
const void* EVP_sha256(void);
unsigned char* HMAC(const void* method, const void* key, int key_size, const unsigned char* data, size_t size, unsigned char* to, unsigned* to_size);
unsigned char* SHA256(const unsigned char* data, size_t size, unsigned char* to);

int curl_global_init(long flags) { return (void)flags, FAILED; }
void curl_global_cleanup(void) {}
void* curl_easy_init(void) { return NULL; }
int curl_easy_setopt(void* handle, int option, ...) { return (void)handle, (void)option, FAILED; }
int curl_easy_perform(void* handle) { return (void)handle, FAILED; }
void curl_easy_cleanup(void* handle) { (void)handle; }
void* curl_slist_append(void* list, const char* text) { return (void)list, (void)text, NULL; }
void curl_slist_free_all(void* list) { (void)list; }
const void* EVP_sha256(void) { return NULL; }
unsigned char* HMAC(const void* method, const void* key, int key_size, const unsigned char* data, size_t size, unsigned char* to, unsigned* to_size) {
  return (void)method, (void)key, (void)key_size, (void)data, (void)size, (void)to, (void)to_size, NULL;
}
unsigned char* SHA256(const unsigned char* data, size_t size, unsigned char* to) { return (void)data, (void)size, (void)to, NULL; }
