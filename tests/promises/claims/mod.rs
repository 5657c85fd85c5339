//! What documentation claims in `# Accuracy` and `# Cost`, and what tests/data/claims.txt says holds it.

pub mod held;
pub mod numbers;
pub mod sections;
