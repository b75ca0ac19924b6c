export { type DecodedPlay, decodePlay, encodePlay, type Unreadable } from './bytes.ts';
export { type ChallengeState, challengeFor } from './challenge.ts';
export { ENGINE_ID } from './engine-id.ts';
export { levelHash } from './level-hash.ts';
export { PLAY_LIMITS, type Play, type PlayClaim, type PlayOutcome } from './play.ts';
export { playOf } from './record.ts';
export type { PlaySigns } from './signs.ts';
export { playFromText, playToText } from './text.ts';
export {
  createVerifier,
  PLAY_VERDICTS,
  type PlaySpan,
  type PlayVerdict,
  type PlayVerifier,
  type VerifiedPlay,
  type VerifyOptions,
  verifyPlay,
} from './verify.ts';
export { type AcceptedAccuracy, claimInWords, whyNotReplayed, whyOtherAccuracy, whyOtherEngine } from './why-not-replayed.ts';
