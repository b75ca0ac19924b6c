export { cacheFolder } from './folder.ts';
export { contentKey, keyOf } from './key.ts';
export { addCacheOptions, type CacheOptions, chosenCache } from './options.ts';
export { codeFingerprint, semantics } from './semantics.ts';
export { openStore, type Store } from './store.ts';
