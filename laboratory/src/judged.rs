//! Judgements of the answers to one question.

/// What has been said of each answer. Several methods often answer with the same bits, and exact arithmetic is
/// asked once for each answer.
#[derive(Debug)]
pub struct Judged<A, V>(Vec<(A, V)>);

impl<A, V> Default for Judged<A, V> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<A: Copy + PartialEq, V: Copy> Judged<A, V> {
    /// The verdict on an answer: `judge`'s if the answer is new, otherwise the same as before.
    pub fn verdict(&mut self, answer: A, judge: impl FnOnce(A) -> V) -> V {
        if let Some((_, verdict)) = self.0.iter().find(|(known, _)| *known == answer) {
            return *verdict;
        }
        let verdict = judge(answer);
        self.0.push((answer, verdict));
        verdict
    }
}
