// SHA-256 of a text's bytes, as server and vehicle tell it. Not from crypto.subtle, which a console that is
// served without TLS to another machine does not have.
import { sha256 } from "@noble/hashes/sha2.js";
import { bytesToHex, utf8ToBytes } from "@noble/hashes/utils.js";

export function hashOf(text: string): string {
  return bytesToHex(sha256(utf8ToBytes(text)));
}
