#include "runtime/script/lua/pose_table.h"

#include "runtime/script/lua/lua_state.h"

namespace gsim::script {

rrs::CartPos check_pose(lua_State* state, int index) {
    luaL_checktype(state, index, LUA_TTABLE);
    rrs::CartPos pose = rrs::CartPos::Identity();
    for (int row = 0; row < 4; ++row) {
        lua_rawgeti(state, index, row + 1);
        luaL_argcheck(state, lua_istable(state, -1), index,
                      "a pose must be a table of four rows of four numbers");
        for (int column = 0; column < 4; ++column) {
            lua_rawgeti(state, -1, column + 1);
            luaL_argcheck(state, lua_isnumber(state, -1) != 0, index,
                          "a pose must be a table of four rows of four numbers");
            pose.matrix()(row, column) = lua_tonumber(state, -1);
            lua_pop(state, 1);
        }
        lua_pop(state, 1);
    }
    return pose;
}

void push_pose(lua_State* state, const rrs::CartPos& pose) {
    lua_createtable(state, 4, 0);
    for (int row = 0; row < 4; ++row) {
        lua_createtable(state, 4, 0);
        for (int column = 0; column < 4; ++column) {
            lua_pushnumber(state, pose.matrix()(row, column));
            lua_rawseti(state, -2, column + 1);
        }
        lua_rawseti(state, -2, row + 1);
    }
}

rrs::JointPos check_joints(lua_State* state, int index, std::size_t count) {
    luaL_checktype(state, index, LUA_TTABLE);
    luaL_argcheck(state, lua_rawlen(state, index) == count, index,
                  "a joint position must have one number for each joint of the machine");
    rrs::JointPos joints(static_cast<Eigen::Index>(count));
    for (std::size_t i = 0; i < count; ++i) {
        lua_rawgeti(state, index, static_cast<lua_Integer>(i) + 1);
        joints[static_cast<Eigen::Index>(i)] = luaL_checknumber(state, -1);
        lua_pop(state, 1);
    }
    return joints;
}

void push_joints(lua_State* state, const rrs::JointPos& joints) {
    lua_createtable(state, static_cast<int>(joints.size()), 0);
    for (Eigen::Index i = 0; i < joints.size(); ++i) {
        lua_pushnumber(state, joints[i]);
        lua_rawseti(state, -2, i + 1);
    }
}

}  // namespace gsim::script
