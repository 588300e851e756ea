#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <limits>
#include <string>

#include "PACKAGE_NAME/storage.hpp"
#include "rclcpp/rclcpp.hpp"

using PACKAGE_NAME::read_text;
using PACKAGE_NAME::Storage;
using PACKAGE_NAME::text_of;

TEST(StorageTest, NumbersReadBackTheSame)
{
  double read = 0.0;
  for (const double value : {0.1, -0.0, 1e308, 5e-324, 1.0 / 3.0}) {
    EXPECT_TRUE(read_text(text_of(value), read));
    EXPECT_EQ(read, value);
  }
  float single = 0.0F;
  EXPECT_EQ(text_of(0.1F), "0.1");
  EXPECT_TRUE(read_text("0.1", single));
  EXPECT_EQ(single, 0.1F);
  uint64_t whole = 0;
  EXPECT_TRUE(read_text(text_of(std::numeric_limits<uint64_t>::max()), whole));
  EXPECT_EQ(whole, std::numeric_limits<uint64_t>::max());
}

TEST(StorageTest, WhatIsNoValueIsRefused)
{
  uint8_t number = 7;
  EXPECT_FALSE(read_text("256", number));
  EXPECT_FALSE(read_text("-1", number));
  EXPECT_FALSE(read_text("1.5", number));
  EXPECT_FALSE(read_text("", number));
  EXPECT_EQ(number, 7);
  bool flag = true;
  EXPECT_FALSE(read_text("yes", flag));
  EXPECT_TRUE(flag);
}

TEST(StorageTest, KeepsValuesFromOneRunToTheNext)
{
  const auto file = std::filesystem::temp_directory_path() /
    ("test_storage_" + std::to_string(getpid())) / "node.txt";
  const double array[3] = {1.0, 2.5, -3.0};
  {
    Storage storage(file, rclcpp::get_logger("test"));
    storage.write("one", 1.25F);
    storage.write("three", array);
    storage.save();
  }
  Storage storage(file, rclcpp::get_logger("test"));
  storage.load();
  float one = 0.0F;
  double three[3] = {};
  bool missing = false;
  EXPECT_TRUE(storage.read("one", one));
  EXPECT_TRUE(storage.read("three", three));
  EXPECT_FALSE(storage.read("missing", missing));
  EXPECT_TRUE(storage.is_good());
  EXPECT_EQ(one, 1.25F);
  EXPECT_EQ(three[1], 2.5);
  float wrong[2] = {};
  EXPECT_FALSE(storage.read("three", wrong));
  EXPECT_FALSE(storage.is_good());
  std::filesystem::remove_all(file.parent_path());
}
