// Included by nearly every file of app.
#include <Eigen/Core>
#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scb/any_collide.h"
#include "scenes/scene/load_scene.h"
