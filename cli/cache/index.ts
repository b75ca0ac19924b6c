export { cacheFolder, addCacheOptions, type CacheOptions, chosenCache } from './options.ts';
export { contentKey, keyOf, codeFingerprint, semantics } from './key.ts';
export { openStore, type Store } from './store.ts';
