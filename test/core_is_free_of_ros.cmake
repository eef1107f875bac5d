# Fails when a source of the core includes a header of ROS.
foreach(folder ${FOLDERS})
  file(GLOB_RECURSE files ${SOURCE_DIR}/src/${folder}/*.cpp
    ${SOURCE_DIR}/include/pomdp_crowd_nav/${folder}/*.h)
  foreach(file ${files})
    file(STRINGS ${file} lines
      REGEX "#include *[<\"](ros/|tf2|actionlib|diagnostic|[a-z_]+_msgs/|pomdp_crowd_nav/ros/)")
    if(lines)
      message(SEND_ERROR "${file} includes ROS: ${lines}")
    endif()
  endforeach()
endforeach()
