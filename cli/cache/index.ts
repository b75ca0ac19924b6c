export { codeFingerprint, contentKey, keyOf, semantics } from './key.ts';
export { addCacheOptions, type CacheOptions, cacheFolder, chosenCache } from './options.ts';
export { openStore, type Store } from './store.ts';
