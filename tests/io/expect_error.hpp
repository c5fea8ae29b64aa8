#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "hatchway/core/error.hpp"

/// Runs `act`, expects hw::Error at a place, and returns its parts for further looks.
inline hw::ErrorParts error_of(const std::function<void()>& act)
{
    try {
        act();
    } catch (const hw::Error& error) {
        return error.parts();
    }
    ADD_FAILURE() << "nothing was refused";
    return {};
}
