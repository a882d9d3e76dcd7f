# The work is done by scripts/; each says at its top what it does.

.PHONY: help demo edit test lint fmt bench clean

help: ## Show this list.
	@echo "make TARGET, where TARGET is"
	@sed -n 's/^\([a-z]*\):.*## \(.*\)/  \1	\2/p' Makefile | expand -t 10

demo: ## Install what is missing, build, and draw a picture and an animation into out/.
	@scripts/demo.sh

edit: ## Build the editor and open it, with SCENE=file if one is named.
	@scripts/edit.sh "$(SCENE)"

test: ## Run all checks and all tests, as CI does.
	@scripts/test.sh

lint: ## Run the checks alone: format, spelling, licences, clippy, documentation.
	@scripts/lint.sh

fmt: ## Format the code.
	cargo fmt --all

bench: ## Measure milliseconds against size, into out/bench/.
	@scripts/bench.sh

clean: ## Remove everything that was built or drawn.
	cargo clean
	rm -rf out
