# Writes the step's sources without what phenomena add to them: -DROOT=… -DOUT=…. Each place must be there, so that a step
# that has changed is looked at again rather than compared with itself.
function(without FILE NAME)
  file(READ ${ROOT}/${FILE} text)
  while(ARGN)
    list(POP_FRONT ARGN what with)
    string(FIND "${text}" "${what}" at)
    if(at EQUAL -1)
      message(FATAL_ERROR "${FILE} no longer has: ${what}")
    endif()
    string(REPLACE "${what}" "${with}" text "${text}")
  endwhile()
  file(WRITE ${OUT}/${NAME} "${text}")
endfunction()

without(engine/step/step.cpp step_without.cpp
  "if (scene->phenomena.any())" "if (false)"
  "if (state.phenomena) state.phenomena->spindle" "if (false) state.phenomena->spindle"
  "if (state.phenomena) rest" "if (false) rest"
  "if (!state.phenomena) {" "if (true) {")
without(engine/step/methods.cpp methods_without.cpp "scene.friction &&" "false &&")
without(engine/step/step_filled.cpp step_filled_without.cpp "scene.friction &&" "false &&")
