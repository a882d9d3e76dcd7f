// What is summed.
alias Item = u32;
