export { type BuiltPack, checkPack, packOf, findPack, isUnplayable, refusedOf, whyRefused } from './pack.ts';
export { GAME, readGame, siteFiles, planSite, type SiteFile, type SiteWords, writeSite } from './site.ts';
