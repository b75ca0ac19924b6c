export { type ChallengeState, challengeFor } from './challenge.ts';
export { type DecodedPlay, decodePlay, type Unreadable } from './decode.ts';
export { encodePlay } from './encode.ts';
export { ENGINE_ID } from './engine-id.ts';
export { PLAY_LIMITS, type PlaySigns } from './format.ts';
export { levelHash } from './level-hash.ts';
export { type Play, type PlayClaim, type PlayOutcome, playOf } from './play.ts';
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
