import { readJson } from '../../json/read-json.ts';
import type { MapSource } from './map-source.ts';
import { isTmx, readTmx } from './read-tmx.ts';

/** Reads the text of a map: JSON (.tmj, .json) or XML (.tmx). */
export const readMapSource = (source: Uint8Array | string): MapSource =>
  isTmx(source) ? readTmx(source) : readJson(source, 'skip');
