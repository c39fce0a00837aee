// SPDX-License-Identifier: MIT
#pragma once

#include <sys/resource.h>

#include <boost/test/unit_test.hpp>

#include <csignal>
#include <cstddef>

namespace stillpoint::cli_test {

/// A limit of the system for every program that is started while it lives.
class Limit {
 public:
  using Kind = decltype(RLIMIT_FSIZE);

  Limit(Kind which, rlim_t most) : which_(which) {
    BOOST_TEST_REQUIRE(::getrlimit(which_, &before_) == 0);
    const rlimit limit{most, before_.rlim_max};
    BOOST_TEST_REQUIRE(::setrlimit(which_, &limit) == 0);
  }
  Limit(const Limit&) = delete;
  Limit& operator=(const Limit&) = delete;
  ~Limit() { ::setrlimit(which_, &before_); }

 private:
  Kind which_;
  rlimit before_{};
};

/// No file can grow beyond this many bytes: a program that writes more gets SIGXFSZ, and an error
/// unless that ends it.
class WriteLimit {
 public:
  WriteLimit(std::size_t bytes, void (*at_the_limit)(int))
      : handler_(std::signal(SIGXFSZ, at_the_limit)), limit_(RLIMIT_FSIZE, bytes) {}
  WriteLimit(const WriteLimit&) = delete;
  WriteLimit& operator=(const WriteLimit&) = delete;
  ~WriteLimit() { std::signal(SIGXFSZ, handler_); }

 private:
  void (*handler_)(int);
  Limit limit_;
};

}  // namespace stillpoint::cli_test
