//! The examples of how the core is extended from outside run: each asserts what it shows.

#[path = "../../examples/new_accelerator.rs"]
mod new_accelerator;
#[path = "../../examples/new_model.rs"]
mod new_model;
#[path = "../../examples/new_primitive.rs"]
mod new_primitive;

#[test]
fn a_new_accelerator_draws_the_same_picture() {
    new_accelerator::main();
}

#[test]
fn a_new_model_lets_light_through_paper() {
    new_model::main();
}

#[test]
fn a_new_primitive_is_met_and_lit() {
    new_primitive::main();
}
