export { type GravityQuestPlugin, makePlugin, type PhaserLike, type PluginClass } from './scene-plugin.ts';
