/**
 * What a synthetic player can do. The times are standard deviations unless they say otherwise.
 *
 * The defaults are from the literature on timing; they were not fitted to players of this game.
 */
export interface PlayerParameters {
  /**
   * Noise of the finger and of what lies behind it, ms: the part of timing noise that neither grows with the interval nor goes away
   * with practice.
   */
  readonly motorMs: number;
  /** Noise of the sense of time as a share of the interval that is timed: scalar timing. */
  readonly weber: number;
  /**
   * Reaction time, ms. A press or release that follows the one before it sooner than this was decided before the player could see
   * what the first one did, so it inherits its error.
   */
  readonly reactionMs: number;
  /**
   * How far ahead a player foresees her motion, ms. A player times a press against what is seen, so no longer interval than this has
   * to be timed; and what a press or release leads to later than this is only guessed.
   */
  readonly lookaheadMs: number;
  /** Error of a first guess at when to press or release where nothing of what follows is foreseen, ms. */
  readonly planMs: number;
  /**
   * Exponent of the power law of practice: what can be learned about a press or release shrinks as (1 + n)^-exponent, where n counts
   * how often the player has made it. A hold after which an attempt failed counts twice.
   */
  readonly learning: number;
  /** The median player's noise and errors of planning are those above, times this. */
  readonly scale: number;
  /** How much players differ: the standard deviation of the logarithm of a player's own factor. */
  readonly spread: number;
}

/**
 * The uncalibrated model.
 * - `motorMs`: the motor delays of A. M. Wing and A. B. Kristofferson (Response delays and the timing of discrete motor responses,
 *   Perception & Psychophysics 14, 1973) vary by about 10 ms; keys and screens add to that (B. Lee and A. Oulasvirta, Modelling error
 *   rates in temporal pointing, CHI 2016).
 * - `weber`: between 0.05 with a rhythm to hold on to and 0.14 without (S. Grondin and P. R. Killeen, Tracking time with song and
 *   count, 2009); noise grows linearly with the interval (J. Gibbon, Scalar expectancy theory, Psychological Review 84, 1977; H.
 *   Merchant, W. Zarco and L. Prado, J. Neurophysiology 99, 2008).
 * - `reactionMs`: simple visual reactions take 231 ms on average (D. L. Woods and others, Factors influencing the latency of simple
 *   reaction time, Frontiers in Human Neuroscience 9, 2015); one that corrects a movement takes a little longer.
 * - `learning`: the power law of practice (A. Newell and P. S. Rosenbloom, Mechanisms of skill acquisition and the law of practice,
 *   1981). The exponent differs much between tasks; 0.4 is a value in the middle.
 * - `lookaheadMs`, `planMs` and `spread` have no source that fits this game: they are assumptions.
 *
 * Together they make a practised player miss by 30 to 60 ms, which is what is found where people press a key for something that moves.
 */
export const UNCALIBRATED: PlayerParameters = {
  motorMs: 20,
  weber: 0.07,
  reactionMs: 250,
  lookaheadMs: 1000,
  planMs: 120,
  learning: 0.4,
  scale: 1,
  spread: 0.3,
};
