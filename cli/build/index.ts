export { type BuiltPack, checkPack, packOf } from './check-pack.ts';
export { findPack } from './pack.ts';
export { GAME, readGame } from './game-files.ts';
export { isUnplayable, refusedOf, whyRefused } from './refused.ts';
export { siteFiles } from './site-files.ts';
export { planSite, type SiteFile, type SiteWords, writeSite } from './site.ts';
