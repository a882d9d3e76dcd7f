// What is summed: four sums at once.
alias Item = vec4u;
