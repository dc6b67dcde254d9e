"""A certificate authority of one's own: small, kept in a folder, good for one fleet."""

import datetime
import ipaddress
from collections.abc import Sequence
from dataclasses import dataclass

from cryptography import x509
from cryptography.hazmat.primitives import hashes, serialization
from cryptography.hazmat.primitives.asymmetric import ec
from cryptography.x509.oid import ExtendedKeyUsageOID, NameOID

AUTHORITY_DAYS = 3650
PARTY_DAYS = 825  # the longest that common TLS libraries take
BACKDATED = datetime.timedelta(days=1)  # for clocks that are a little behind

Key = ec.EllipticCurvePrivateKey


@dataclass(frozen=True)
class Credentials:
    """A private key and its certificate, both PEM."""

    key: bytes
    certificate: bytes


def new_authority(name: str = "Bumpless fleet") -> Credentials:
    """Key and certificate of a new authority, which may sign parties and nothing above them."""
    key = ec.generate_private_key(ec.SECP256R1())
    builder = _builder(name, _name(name), key, AUTHORITY_DAYS)
    usage = x509.KeyUsage(
        digital_signature=False,
        content_commitment=False,
        key_encipherment=False,
        data_encipherment=False,
        key_agreement=False,
        key_cert_sign=True,
        crl_sign=True,
        encipher_only=False,
        decipher_only=False,
    )
    certificate = (
        builder.add_extension(x509.BasicConstraints(ca=True, path_length=0), critical=True)
        .add_extension(usage, critical=True)
        .sign(key, hashes.SHA256())
    )
    return Credentials(_pem(key), certificate.public_bytes(serialization.Encoding.PEM))


def sign_party(authority: Credentials, common_name: str, hosts: Sequence[str] = ()) -> Credentials:
    """Key and certificate of one party; `hosts` are the names and addresses by which others reach it.

    Raises ValueError when the authority's files are none.
    """
    signer = serialization.load_pem_private_key(authority.key, password=None)
    issuer = x509.load_pem_x509_certificate(authority.certificate)
    if not isinstance(signer, Key):
        raise ValueError("the authority's key is not an elliptic curve's")
    key = ec.generate_private_key(ec.SECP256R1())
    usage = x509.ExtendedKeyUsage([ExtendedKeyUsageOID.SERVER_AUTH, ExtendedKeyUsageOID.CLIENT_AUTH])
    builder = (
        _builder(common_name, issuer.subject, key, PARTY_DAYS)
        .add_extension(usage, critical=False)
        .add_extension(x509.BasicConstraints(ca=False, path_length=None), critical=True)
    )
    if hosts:
        names = x509.SubjectAlternativeName([_host(host) for host in hosts])
        builder = builder.add_extension(names, critical=False)
    certificate = builder.sign(signer, hashes.SHA256())
    return Credentials(_pem(key), certificate.public_bytes(serialization.Encoding.PEM))


def common_name_of(certificate: bytes) -> str:
    """Whose certificate this PEM is."""
    subject = x509.load_pem_x509_certificate(certificate).subject
    return str(subject.get_attributes_for_oid(NameOID.COMMON_NAME)[0].value)


def _builder(common_name: str, issuer: x509.Name, key: Key, days: int) -> x509.CertificateBuilder:
    now = datetime.datetime.now(datetime.UTC)
    return (
        x509.CertificateBuilder()
        .subject_name(_name(common_name))
        .issuer_name(issuer)
        .public_key(key.public_key())
        .serial_number(x509.random_serial_number())
        .not_valid_before(now - BACKDATED)
        .not_valid_after(now + datetime.timedelta(days=days))
    )


def _name(common_name: str) -> x509.Name:
    return x509.Name([x509.NameAttribute(NameOID.COMMON_NAME, common_name)])


def _host(host: str) -> x509.GeneralName:
    try:
        return x509.IPAddress(ipaddress.ip_address(host))
    except ValueError:
        return x509.DNSName(host)


def _pem(key: Key) -> bytes:
    return key.private_bytes(
        serialization.Encoding.PEM, serialization.PrivateFormat.PKCS8, serialization.NoEncryption()
    )
