# STILLPOINT_LEFT_OUT: the files of the rooms that the page does without. They do what a page does not do, need what its library lacks, or
# take long to compile: sweeps, the comparison with other integrators, the command line.
set(STILLPOINT_LEFT_OUT "src/(comparison|exact|kernel|reference|regularised)|src/figure_map"
  "src/(run|rows|map|merge|reducer|reduction|step|checkpoint|sink|state|list_source|request_of|grid|npy|identity)|src/posix/(output|output_file|open_rows|part_file)"
  "src/(accuracy|browser|sweep|terminal)|src/figures/(choices|sweep)|src/json/(accuracy|reduction.*|sweep)"
  "accuracy|commands|messages|output|progress|sweep|input/sweep|options/command_line")
list(JOIN STILLPOINT_LEFT_OUT "|" STILLPOINT_LEFT_OUT)
set(STILLPOINT_LEFT_OUT "^(${STILLPOINT_LEFT_OUT})\\.cpp$")
